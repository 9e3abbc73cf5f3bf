package troupe.paint.field;

import java.awt.Color;
import troupe.paint.Shapes;
import troupe.paint.Theme;

/**
 * Turns a share in [0, 1] into a colour whose lightness runs one way only, so that order can be read with
 * any colour vision and in grey: from the floor's lightness to its opposite.
 */
public final class ColourMap {
    private static final int[] LIGHT = {
        0xf4f7e4, 0xdcecc9, 0xb9dfc0, 0x8fcfbd, 0x64b9bb, 0x439db3, 0x337fa5, 0x315f93, 0x2e407a
    };
    private static final int[] DARK = {
        0x20264a, 0x24406f, 0x255d86, 0x2b7a93, 0x41979b, 0x66b3a0, 0x94cca6, 0xc4e2b4, 0xeef5cf
    };

    private final int[] table = new int[256];

    /** Makes the map of a theme. */
    public ColourMap(Theme theme) {
        int[] stops = theme == Theme.LIGHT ? LIGHT : DARK;
        for (int i = 0; i < table.length; i++) {
            double at = i * (stops.length - 1) / 255.0;
            int k = Math.min((int) at, stops.length - 2);
            table[i] = Shapes.blend(new Color(stops[k]), new Color(stops[k + 1]), at - k)
                    .getRGB();
        }
    }

    private ColourMap(Color from, Color to) {
        for (int i = 0; i < table.length; i++) {
            table[i] = Shapes.blend(from, to, i / 255.0).getRGB();
        }
    }

    /** Makes a map of greys, from the floor to ink, as for probabilities. */
    public static ColourMap greys(Theme theme) {
        return theme == Theme.LIGHT
                ? new ColourMap(new Color(0xf4f4f4), new Color(0x141414))
                : new ColourMap(new Color(0x2a2a2a), new Color(0xf2f2f2));
    }

    /** Makes the map for fields of a key: greys for probabilities, colours for all others. */
    public static ColourMap of(String key, Theme theme) {
        return key.equals("probability") ? greys(theme) : new ColourMap(theme);
    }

    /** Returns the opaque colour {@code 0xffrrggbb} of a share; below 0 counts as 0, above 1 as 1. */
    public int argb(double share) {
        return table[(int) Math.max(0, Math.min(255, Math.round(share * 255)))];
    }
}
