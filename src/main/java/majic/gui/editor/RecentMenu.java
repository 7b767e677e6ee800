package majic.gui.editor;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import majic.text.Texts;

/** The entries of the menu of recent files. */
public final class RecentMenu {
    private static final Texts TEXTS = Texts.of(RecentMenu.class);

    private RecentMenu() {}

    /**
     * Replaces the entries of the menu by the recent files.
     *
     * @param open receives the file that is chosen
     */
    public static void fill(JMenu menu, RecentFiles recent, Consumer<Path> open) {
        menu.removeAll();
        List<Path> files = recent.list();
        for (int index = 0; index < files.size(); index++) {
            Path file = files.get(index);
            JMenuItem item = new JMenuItem((index + 1) % 10 + "  " + file.getFileName());
            item.setMnemonic('0' + (index + 1) % 10);
            item.setToolTipText(file.toString());
            item.addActionListener(event -> open.accept(file));
            menu.add(item);
        }
        if (files.isEmpty()) {
            menu.add(new JMenuItem(TEXTS.get("recent.none"))).setEnabled(false);
        }
    }
}
