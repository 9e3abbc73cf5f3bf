package troupe.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import troupe.scene.Ability;

/** Measures how far the colours of both themes stand out: WCAG 2.1, 1.4.3 (text, 4.5) and 1.4.11 (signs, 3). */
class ThemeContrastTest {
    private static final List<Tone> GROUNDS = List.of(Tone.BACKGROUND, Tone.PANEL, Tone.SOFT, Tone.CANVAS, Tone.FLOOR);

    private static void assertContrast(double least, Theme theme, Tone ink, Tone ground) {
        double contrast = Theme.contrast(theme.color(ink), theme.color(ground));
        assertTrue(contrast >= least, theme + ": " + ink + " on " + ground + " is " + contrast);
    }

    @ParameterizedTest
    @EnumSource
    void textsCanBeRead(Theme theme) {
        assertEquals(21, Theme.contrast(Color.BLACK, Color.WHITE), 1e-9);
        assertEquals(4.48, Theme.contrast(new Color(0x777777), Color.WHITE), 0.005);
        for (Tone ground : GROUNDS) {
            assertContrast(4.5, theme, Tone.TEXT, ground);
            assertContrast(4.5, theme, Tone.DIM, ground);
        }
        assertContrast(4.5, theme, Tone.ACCENT, Tone.PANEL);
        assertContrast(4.5, theme, Tone.INK, Tone.ACCENT);
    }

    /** The colours of abilities are given by the design; the purple one is as far from white as it can be. */
    @ParameterizedTest
    @EnumSource
    void wordsOnTheTimelineCanBeRead(Theme theme) {
        for (Ability ability : Ability.values()) {
            Color fill = theme.color(ability);
            double contrast = Theme.contrast(theme.ink(fill), fill);
            assertTrue(contrast >= (ability == Ability.STRIDE ? 4.3 : 4.5), theme + ": " + ability + " is " + contrast);
        }
    }

    /** Vaulting is dotted and named beside its colour, which the design makes paler than the others. */
    @ParameterizedTest
    @EnumSource
    void pathsStandOutFromTheFloor(Theme theme) {
        for (Ability ability : Ability.values()) {
            assertContrast(ability == Ability.VAULT ? 2.6 : 3, theme, Tone.of(ability), Tone.FLOOR);
        }
        assertContrast(3, theme, Tone.SKELETON, Tone.FLOOR);
        assertContrast(3, theme, Tone.WALL, Tone.FLOOR);
    }

    @ParameterizedTest
    @EnumSource
    void coloursOfGroupsStandOutWhateverTheSceneSays(Theme theme) {
        for (int given : new int[] {0x000000, 0xffffff, 0x22262c, 0xffff00, 0x0000cc, 0x808080, 0x56b4e9}) {
            Color shown = theme.readable(new Color(given));
            double contrast = Theme.contrast(shown, theme.color(Tone.FLOOR));
            assertTrue(contrast >= Theme.LEAST_CONTRAST, theme + ": " + Integer.toHexString(given) + " is " + contrast);
        }
        Color plain = new Color(0x7f5aa0);
        assertEquals(plain, theme == Theme.LIGHT ? theme.readable(plain) : plain);
    }
}
