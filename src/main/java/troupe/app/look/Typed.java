package troupe.app.look;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/**
 * Does something with each change of the characters of a field.
 *
 * @param changed what to do
 */
public record Typed(Runnable changed) implements DocumentListener {

    @Override
    public void insertUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        changed.run();
    }
}
