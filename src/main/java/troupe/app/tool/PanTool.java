package troupe.app.tool;

import java.awt.Cursor;
import java.util.function.BiConsumer;

/** Moves the view with the pointer. */
public final class PanTool implements Tool {
    private final BiConsumer<Double, Double> pan;
    private double px;
    private double py;

    /** Makes the tool; {@code pan} moves the view by pixels, right and down. */
    public PanTool(BiConsumer<Double, Double> pan) {
        this.pan = pan;
    }

    @Override
    public String key() {
        return "pan";
    }

    @Override
    public void press(Pointer pointer) {
        px = pointer.px();
        py = pointer.py();
    }

    @Override
    public void drag(Pointer pointer) {
        pan.accept(pointer.px() - px, pointer.py() - py);
        px = pointer.px();
        py = pointer.py();
    }

    @Override
    public void release(Pointer pointer) {
        // the view has been moved already
    }

    @Override
    public void cancel() {
        // a moved view is no change of the document
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
    }
}
