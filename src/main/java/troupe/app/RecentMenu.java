package troupe.app;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import troupe.app.look.Look;

/** Offers the files that were opened last, as they are when the menu is unfolded. */
final class RecentMenu extends JMenu {
    private final transient Look look;
    private final transient Supplier<List<Path>> files;
    private final transient Consumer<Path> open;

    RecentMenu(Look look, Supplier<List<Path>> files, Consumer<Path> open) {
        super(look.text("menu.recent"));
        this.look = look;
        this.files = files;
        this.open = open;
        setName("menu.recent");
        setFont(look.font());
        addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent event) {
                fill();
            }

            @Override
            public void menuDeselected(MenuEvent event) {
                // the items stay until the next time
            }

            @Override
            public void menuCanceled(MenuEvent event) {
                // the items stay until the next time
            }
        });
        fill();
    }

    private void fill() {
        removeAll();
        for (Path file : files.get()) {
            JMenuItem item = new JMenuItem(file.getFileName().toString());
            item.setName("recent." + file.getFileName());
            item.setToolTipText(file.toString());
            item.addActionListener(e -> open.accept(file));
            add(item);
        }
        if (getItemCount() == 0) {
            JMenuItem none = new JMenuItem(look.text("menu.recent.none"));
            none.setEnabled(false);
            add(none);
        }
    }
}
