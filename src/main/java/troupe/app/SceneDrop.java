package troupe.app;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Takes a file that is dropped on the window. */
final class SceneDrop extends TransferHandler {
    private final transient Consumer<Path> open;

    SceneDrop(Consumer<Path> open) {
        this.open = open;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDrop() && support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<Path> file =
                support.isDataFlavorSupported(DataFlavor.javaFileListFlavor) ? first(support) : Optional.empty();
        file.ifPresent(open);
        return file.isPresent();
    }

    private static Optional<Path> first(TransferSupport support) {
        try {
            Object dropped = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            return dropped instanceof List<?> files && !files.isEmpty() && files.get(0) instanceof File file
                    ? Optional.of(file.toPath())
                    : Optional.empty();
        } catch (UnsupportedFlavorException | IOException e) {
            // who dragged it here has taken it back; nothing is opened
            return Optional.empty();
        }
    }
}
