package majic.gui;

import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Window;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import majic.gui.kit.Mnemonics;
import majic.text.Texts;

/** The menu of the other windows of MAJIC, such as plots and replays; an entry brings its window to the front. */
final class WindowMenu {
    private static final Texts TEXTS = Texts.of(WindowMenu.class);

    private WindowMenu() {}

    /** Lists the windows that are open whenever the menu is opened. */
    static void fill(JMenu menu) {
        list(menu);
        menu.addChangeListener(change -> {
            if (menu.isSelected()) {
                list(menu);
            }
        });
    }

    private static void list(JMenu menu) {
        menu.removeAll();
        Window main = SwingUtilities.getWindowAncestor(menu);
        Stream.of(Window.getWindows())
                .filter(window -> window.isShowing() && window != main)
                .forEach(window -> title(window).ifPresent(title -> add(menu, title, window)));
        if (menu.getItemCount() == 0) {
            menu.add(new JMenuItem(TEXTS.get("noWindows"))).setEnabled(false);
        }
        Mnemonics.assign(menu);
    }

    /** Popups have no title. */
    private static Optional<String> title(Window window) {
        if (window instanceof Frame frame) {
            return Optional.of(frame.getTitle());
        }
        return window instanceof Dialog dialog ? Optional.of(dialog.getTitle()) : Optional.empty();
    }

    private static void add(JMenu menu, String title, Window window) {
        menu.add(new JMenuItem(title)).addActionListener(event -> {
            if (window instanceof Frame frame) {
                frame.setExtendedState(frame.getExtendedState() & ~Frame.ICONIFIED);
            }
            window.toFront();
            window.requestFocus();
        });
    }
}
