package majic.gui.kit;

import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.RootPaneContainer;
import majic.panel.KeyAction;

/** The key that closes a window beside the main one, as the button in its title bar does: Ctrl W, Cmd W on a Mac. */
public final class CloseKey {
    private CloseKey() {}

    /** Lets the key close a window while the window has the focus. Must be called on the event dispatch thread. */
    public static <W extends Window & RootPaneContainer> void install(W window) {
        int menuKey = Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
        KeyAction.bind(
                window.getRootPane(),
                JComponent.WHEN_IN_FOCUSED_WINDOW,
                KeyStroke.getKeyStroke(KeyEvent.VK_W, menuKey),
                event -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
    }
}
