package troupe.paint;

import java.awt.Color;
import troupe.scene.Ability;

/** Names what a colour is for, and holds it for the light and the dark theme. */
public enum Tone {
    BACKGROUND(0xf4f5f7, 0x1e2126),
    PANEL(0xffffff, 0x26292f),
    LINE(0xdfe2e7, 0x373b43),
    TEXT(0x1d232b, 0xe4e7ec),
    DIM(0x5e6874, 0x98a1ad),
    ACCENT(0x0b67c2, 0x58a6ff),
    CANVAS(0xe9ebee, 0x17191d),
    FLOOR(0xfbfbf9, 0x24272c),
    GRID(0xeceeea, 0x2b2f35),
    WALL(0x4a525d, 0x7b8593),
    WALL_TOP(0x5c6673, 0x8b95a3),
    SOFT(0xf0f2f5, 0x2e323a),
    WALK(0x0072b2, 0x56a9e0),
    SIDESTEP(0x009e73, 0x35c79d),
    STRIDE(0xb45a93, 0xd98cbb),
    VAULT(0xd98a00, 0xf0b03f),
    MOVE(0xc2410c, 0xf07a3c),
    SKELETON(0x59a14f, 0x7fc274),
    CONTOUR(0x9fb6cc, 0x46607a),
    LOW(0xc9a45c, 0xc9a45c),
    STEP(0x8d98a6, 0x6f7987),
    DECK(0xb9a27c, 0xa8926c),
    DECK_EDGE(0xa08a60, 0xc2ad84),
    DITCH(0x7fa6bd, 0x6a93ab),
    DITCH_EDGE(0x5f8aa3, 0x8fb7cc),
    WOOD(0xb4783c, 0xb4783c),
    GRAIN(0x8f5c2a, 0x8f5c2a),
    GHOST(0x8f5c2a, 0xc08a55),
    INK(0xffffff, 0x14171b);

    private final Color light;
    private final Color dark;

    Tone(int light, int dark) {
        this.light = new Color(light);
        this.dark = new Color(dark);
    }

    Color light() {
        return light;
    }

    Color dark() {
        return dark;
    }

    /** Returns the colour of an ability, the same in paths, timelines, bars and plots. */
    public static Tone of(Ability ability) {
        return switch (ability) {
            case WALK -> WALK;
            case SIDESTEP -> SIDESTEP;
            case STRIDE -> STRIDE;
            case VAULT -> VAULT;
            case MOVE -> MOVE;
        };
    }
}
