package majic.pictures;

import java.awt.Window;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.SwingUtilities;
import majic.gui.MajicFrame;
import majic.gui.kit.LoginDialog;
import majic.program.Program;

/**
 * Opens every dialog that the menus of the window open, the one after Load Act, and the login, for pictures of them.
 */
final class DialogPictures {
    private final Program program;
    private final MajicFrame frame;
    private final Painter painter;

    /** Paints a window with the dialogs that belong to it. */
    interface Painter {
        void paint(JFrame window, String name) throws Exception;
    }

    DialogPictures(Program program, MajicFrame frame, Painter painter) {
        this.program = program;
        this.frame = frame;
        this.painter = painter;
    }

    void paint() throws Exception {
        for (JMenuItem entry : entries()) {
            paint(entry.getText(), entry::doClick);
        }
        paint("login", () -> LoginDialog.ask(frame, "mqtt://broker/lab", program.sharing(), () -> {}, line -> false));
        SwingUtilities.invokeAndWait(frame::loadAct);
        paint(
                "choose act",
                () -> shown().filter(JDialog.class::isInstance)
                        .forEach(dialog -> ((JDialog) dialog)
                                .getRootPane()
                                .getDefaultButton()
                                .doClick()));
    }

    /** The entries that open dialogs: those with an ellipsis, and those of the last menu, Help. */
    private List<JMenuItem> entries() {
        int menus = frame.getJMenuBar().getMenuCount();
        JMenu help = frame.getJMenuBar().getMenu(menus - 1);
        return IntStream.range(0, menus)
                .mapToObj(frame.getJMenuBar()::getMenu)
                .flatMap(menu -> Stream.of(menu.getMenuComponents())
                        .filter(JMenuItem.class::isInstance)
                        .map(JMenuItem.class::cast)
                        .filter(entry -> menu == help || entry.getText().endsWith("…")))
                .filter(entry -> !(entry instanceof JMenu || entry instanceof JCheckBoxMenuItem))
                .filter(entry -> !(entry instanceof JRadioButtonMenuItem) && entry.isEnabled())
                .toList();
    }

    private void paint(String name, Runnable opening) throws Exception {
        SwingUtilities.invokeAndWait(opening);
        PictureWindow.awaitWindow(() -> shown().findAny().isPresent());
        JFrame painted = shown().filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst()
                .orElse(frame);
        // The tour is placed beside the window, where a picture of the window does not show it.
        SwingUtilities.invokeAndWait(() -> shown().filter(window ->
                        window.getOwner() == frame && !frame.getBounds().contains(window.getBounds()))
                .forEach(window -> window.setLocationRelativeTo(frame)));
        painter.paint(
                painted,
                "dialog-" + name.toLowerCase(Locale.ROOT).replace("…", "").replace(' ', '-'));
        for (Window window : shown().toList()) {
            SwingUtilities.invokeAndWait(window::dispose);
        }
    }

    private Stream<Window> shown() {
        return Arrays.stream(Window.getWindows())
                .filter(window -> window != frame && window.isShowing())
                .filter(window -> window instanceof JDialog || window instanceof JFrame);
    }
}
