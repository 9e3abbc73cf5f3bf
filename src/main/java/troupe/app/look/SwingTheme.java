package troupe.app.look;

import java.awt.Color;
import java.awt.Font;
import java.awt.Insets;
import java.awt.RenderingHints;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.UIDefaults;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.border.Border;
import javax.swing.plaf.BorderUIResource;
import javax.swing.plaf.ColorUIResource;
import javax.swing.plaf.FontUIResource;
import javax.swing.plaf.InsetsUIResource;
import javax.swing.plaf.metal.DefaultMetalTheme;
import javax.swing.plaf.metal.MetalLookAndFeel;
import troupe.paint.Tone;

/** Dresses the JDK's own components (menus, dialogs, file choosers) in the colours of a theme. */
public final class SwingTheme extends DefaultMetalTheme {
    private static final String CHOOSER = "filechooser.";

    private final Look look;

    private SwingTheme(Look look) {
        this.look = look;
    }

    /** Dresses every component that is made from now on. Belongs to the event thread. */
    public static void install(Look look) {
        SwingTheme theme = new SwingTheme(look);
        MetalLookAndFeel.setCurrentTheme(theme);
        JFrame.setDefaultLookAndFeelDecorated(false);
        JDialog.setDefaultLookAndFeelDecorated(false);
        UIManager.put("swing.boldMetal", Boolean.FALSE);
        try {
            UIManager.setLookAndFeel(new MetalLookAndFeel());
        } catch (UnsupportedLookAndFeelException e) {
            throw new IllegalStateException("the JDK's own look and feel is not supported here", e);
        }
        UIDefaults defaults = UIManager.getLookAndFeelDefaults();
        defaults.put(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        theme.dress(defaults);
    }

    private void dress(UIDefaults defaults) {
        Color panel = look.color(Tone.PANEL);
        Color text = look.color(Tone.TEXT);
        Color selected = look.mix(Tone.ACCENT, Tone.PANEL, 0.18);
        for (String gradient : new String[] {
            "Button.gradient", "CheckBox.gradient", "CheckBoxMenuItem.gradient", "InternalFrame.activeTitleGradient",
            "MenuBar.gradient", "RadioButton.gradient", "RadioButtonMenuItem.gradient", "ScrollBar.gradient",
            "Slider.gradient", "ToggleButton.gradient", "Slider.focusGradient"
        }) {
            defaults.put(gradient, null);
        }
        for (String part : new String[] {"Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem"}) {
            defaults.put(part + ".background", resource(panel));
            defaults.put(part + ".foreground", resource(text));
            defaults.put(part + ".selectionBackground", resource(selected));
            defaults.put(part + ".selectionForeground", resource(text));
            defaults.put(part + ".acceleratorForeground", resource(look.color(Tone.DIM)));
            defaults.put(part + ".acceleratorSelectionForeground", resource(look.color(Tone.DIM)));
            defaults.put(part + ".acceleratorFont", new FontUIResource(look.font()));
            defaults.put(part + ".border", border(4, 8, 4, 12));
            defaults.put(part + ".borderPainted", Boolean.FALSE);
            defaults.put(part + ".acceleratorDelimiter", "+");
            defaults.put(part + ".afterCheckIconGap", look.px(6));
        }
        defaults.put("MenuBar.border", border(0, 0, 0, 0));
        defaults.put("MenuItemUI", RoomyMenuItems.Plain.class.getName());
        defaults.put("CheckBoxMenuItemUI", RoomyMenuItems.Choice.class.getName());
        defaults.put("PopupMenu.border", frame(4));
        defaults.put("PopupMenu.background", resource(panel));
        defaults.put("ToolTip.background", resource(look.color(Tone.PANEL)));
        defaults.put("ToolTip.foreground", resource(text));
        defaults.put("ToolTip.border", frame(5));
        defaults.put("TextField.background", resource(look.color(Tone.BACKGROUND)));
        defaults.put("TextField.foreground", resource(text));
        defaults.put("TextField.caretForeground", resource(text));
        defaults.put("TextField.border", frame(4));
        defaults.put("List.background", resource(panel));
        defaults.put("List.selectionBackground", resource(selected));
        defaults.put("List.selectionForeground", resource(text));
        defaults.put("ScrollPane.border", border(0, 0, 0, 0));
        defaults.put("SplitPane.border", border(0, 0, 0, 0));
        defaults.put("SplitPaneDivider.border", border(0, 0, 0, 0));
        defaults.put("Button.margin", new InsetsUIResource(look.px(4), look.px(14), look.px(4), look.px(14)));
        defaults.put("Separator.foreground", resource(look.color(Tone.LINE)));
        defaults.put("Separator.background", resource(panel));
        words(defaults);
    }

    /** Gives the JDK's own dialogs the words of the language. */
    private void words(UIDefaults defaults) {
        look.texts().under(CHOOSER).forEach((key, word) -> defaults.put("FileChooser." + key, word));
        defaults.put("OptionPane.okButtonText", look.text("ok"));
    }

    private static ColorUIResource resource(Color color) {
        return new ColorUIResource(color);
    }

    private BorderUIResource border(int top, int left, int bottom, int right) {
        Insets insets = new Insets(look.px(top), look.px(left), look.px(bottom), look.px(right));
        return new BorderUIResource(
                BorderFactory.createEmptyBorder(insets.top, insets.left, insets.bottom, insets.right));
    }

    private BorderUIResource frame(int padding) {
        Border line = BorderFactory.createLineBorder(look.color(Tone.LINE));
        Border space = BorderFactory.createEmptyBorder(
                look.px(padding), look.px(padding + 2), look.px(padding), look.px(padding + 2));
        return new BorderUIResource(BorderFactory.createCompoundBorder(line, space));
    }

    @Override
    public String getName() {
        return "Troupe " + look.theme().key();
    }

    @Override
    protected ColorUIResource getPrimary1() {
        return resource(look.color(Tone.ACCENT));
    }

    @Override
    protected ColorUIResource getPrimary2() {
        return resource(look.mix(Tone.ACCENT, Tone.PANEL, 0.35));
    }

    @Override
    protected ColorUIResource getPrimary3() {
        return resource(look.mix(Tone.ACCENT, Tone.PANEL, 0.25));
    }

    @Override
    protected ColorUIResource getSecondary1() {
        return resource(look.mix(Tone.DIM, Tone.PANEL, 0.5));
    }

    @Override
    protected ColorUIResource getSecondary2() {
        return resource(look.color(Tone.LINE));
    }

    @Override
    protected ColorUIResource getSecondary3() {
        return resource(look.color(Tone.PANEL));
    }

    @Override
    protected ColorUIResource getBlack() {
        return resource(look.color(Tone.TEXT));
    }

    @Override
    protected ColorUIResource getWhite() {
        return resource(look.color(Tone.BACKGROUND));
    }

    private FontUIResource plain() {
        return new FontUIResource(look.font().deriveFont(Font.PLAIN));
    }

    @Override
    public FontUIResource getControlTextFont() {
        return plain();
    }

    @Override
    public FontUIResource getSystemTextFont() {
        return plain();
    }

    @Override
    public FontUIResource getUserTextFont() {
        return plain();
    }

    @Override
    public FontUIResource getMenuTextFont() {
        return plain();
    }

    @Override
    public FontUIResource getWindowTitleFont() {
        return plain();
    }

    @Override
    public FontUIResource getSubTextFont() {
        return plain();
    }
}
