package troupe.app.start;

import java.awt.Dimension;
import java.awt.GridLayout;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JPanel;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.NumberField;
import troupe.paint.Tone;
import troupe.scene.Scene;

/** Makes a new scene: of a size with a name at one click, or of any size. */
public final class NewScenePanel extends JPanel {
    private final transient Look look;
    private final transient Consumer<Scene> create;
    private double width = 10;
    private double depth = 8;

    /** Makes the panel; {@code create} is given the new scene. */
    public NewScenePanel(Look look, Consumer<Scene> create) {
        this.look = look;
        this.create = create;
        setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
        setOpaque(false);
        JPanel sizes = new JPanel(new GridLayout(BlankScene.SIZES.size(), 1, 0, 6));
        sizes.setOpaque(false);
        for (BlankScene size : BlankScene.SIZES) {
            sizes.add(sized(size));
        }
        add(left(sizes));
        JPanel own = new JPanel();
        own.setLayout(new BoxLayout(own, BoxLayout.X_AXIS));
        own.setOpaque(false);
        own.setBorder(BorderFactory.createEmptyBorder(8, 0, 0, 0));
        own.add(field("new.width", width, metres -> width = metres));
        own.add(Box.createHorizontalStrut(6));
        own.add(look.label("\u00d7", Tone.DIM));
        own.add(Box.createHorizontalStrut(6));
        own.add(field("new.depth", depth, metres -> depth = metres));
        FlatButton button = new FlatButton(look, FlatButton.Style.PILL);
        button.setText(look.text("new.create"));
        button.setName("new.create");
        button.addActionListener(e -> {
            button.setSelected(false);
            create.accept(new BlankScene("", width, depth).scene(look.texts()));
        });
        own.add(Box.createHorizontalStrut(8));
        own.add(button);
        add(left(own));
    }

    private static <C extends JComponent> C left(C part) {
        part.setAlignmentX(LEFT_ALIGNMENT);
        return part;
    }

    private FlatButton sized(BlankScene size) {
        FlatButton button = new FlatButton(look, FlatButton.Style.PILL);
        button.setText(look.text("new." + size.key()));
        button.setHint(Texts.number(size.width(), 0) + " \u00d7 " + Texts.number(size.depth(), 0) + " m");
        button.setName("new." + size.key());
        button.addActionListener(e -> {
            button.setSelected(false);
            create.accept(size.scene(look.texts()));
        });
        return button;
    }

    private NumberField field(String key, double shown, java.util.function.DoubleConsumer taken) {
        NumberField field = new NumberField(look, "m", 1);
        field.setName(key);
        field.getAccessibleContext().setAccessibleName(look.text(key));
        field.setToolTipText(look.text(key));
        field.setPreferredSize(new Dimension(68, 28));
        field.onNumber(BlankScene::isSide, taken);
        field.show(shown);
        return field;
    }
}
