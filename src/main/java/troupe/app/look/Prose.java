package troupe.app.look;

import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;
import troupe.paint.Tone;

/** Shows some sentences on a soft card, broken into lines; they can be selected and copied, not changed. */
public class Prose extends JTextArea {
    private static final int COLUMNS = 18;
    private static final int WIDTH = 240;

    /** Makes a card with a text. */
    public Prose(Look look, String text) {
        super(text);
        // a caret that follows the text would scroll the panel to the card whenever it changes
        DefaultCaret still = new DefaultCaret();
        still.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        setCaret(still);
        setLineWrap(true);
        setWrapStyleWord(true);
        setEditable(false);
        setFont(look.font());
        setForeground(look.color(Tone.TEXT));
        setBackground(look.color(Tone.SOFT));
        setColumns(COLUMNS);
        setSize(look.px(WIDTH), 10);
    }
}
