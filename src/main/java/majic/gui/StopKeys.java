package majic.gui;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.MajicDialog;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * Makes F12 and Esc stop all robots in every window and dialog, whatever component has the focus. F12 always stops. Esc
 * does not stop while it has something to close: a menu, an open list, a dialog, or what a {@link ClosesByEsc} has
 * open. A dialog that has opened by itself since the previous Esc, such as one that waited for a file, does not count.
 *
 * <p>F12 does not wait for the event dispatch thread: while that thread handles an earlier event, the thread "early
 * keys" stops. Esc waits, because what it closes is known only when all earlier events were handled.
 */
final class StopKeys implements KeyEventDispatcher, AutoCloseable {
    private final Team team;
    private final Runnable stopAll;
    private final EarlyKeyQueue queue = EarlyKeyQueue.installed();
    private final Consumer<KeyEvent> pressedEarly = this::stopEarly;
    private final AWTEventListener mouse = this::mouseUsed;

    /** The windows at the last press of Esc; null once another key or the mouse was pressed. */
    private @Nullable Set<Window> openAtEsc;

    /** The presses of F12 that have stopped before the event dispatch thread received them. */
    private final Set<KeyEvent> early = Collections.synchronizedSet(Collections.newSetFromMap(new WeakHashMap<>()));

    /**
     * Creates the keys; {@link #install()} makes them work.
     *
     * @param team the robots
     * @param stopAll stops all robots, and shows on the event dispatch thread if there is none
     */
    StopKeys(Team team, Runnable stopAll) {
        this.team = team;
        this.stopAll = stopAll;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
        Toolkit.getDefaultToolkit().addAWTEventListener(mouse, AWTEvent.MOUSE_EVENT_MASK);
        queue.addListener(pressedEarly);
    }

    /** Called on the thread "early keys". Without a robot, the key is left to the event dispatch thread. */
    private void stopEarly(KeyEvent event) {
        if (event.getKeyCode() == KeyEvent.VK_F12) {
            early.add(event);
            boolean stopped = false;
            try {
                stopped = team.stopAllIfAny();
            } finally {
                if (!stopped) {
                    early.remove(event);
                }
            }
        }
    }

    /** Runs before the focused component receives the key, which is passed on in any case. */
    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        boolean stops =
                event.getKeyCode() == KeyEvent.VK_F12 || (event.getKeyCode() == KeyEvent.VK_ESCAPE && !escCloses());
        if (event.getID() == KeyEvent.KEY_PRESSED && stops && !hasStopped(event)) {
            stopAll.run();
        }
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            openAtEsc = event.getKeyCode() == KeyEvent.VK_ESCAPE ? showing() : null;
        }
        return false;
    }

    private static Set<Window> showing() {
        Set<Window> windows = Collections.newSetFromMap(new WeakHashMap<>());
        Stream.of(Window.getWindows()).filter(Window::isShowing).forEach(windows::add);
        return windows;
    }

    private void mouseUsed(AWTEvent event) {
        if (event.getID() == MouseEvent.MOUSE_PRESSED) {
            openAtEsc = null;
        }
    }

    /** An early stop does not count if input from before the key, such as a click on Release, has released it. */
    private boolean hasStopped(KeyEvent event) {
        return early.remove(event) && team.isLatched();
    }

    private boolean escCloses() {
        KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0
                || isInOpenList(focus.getFocusOwner())
                || isOpenedByUser(focus.getFocusedWindow())
                || isInOpen(focus.getFocusOwner());
    }

    private boolean isOpenedByUser(@Nullable Window focused) {
        return focused instanceof MajicDialog && (openAtEsc == null || openAtEsc.contains(focused));
    }

    private static boolean isInOpen(@Nullable Component focused) {
        for (Component component = focused; component != null; component = component.getParent()) {
            if (component instanceof ClosesByEsc closing && closing.hasToClose()) {
                return true;
            }
        }
        return false;
    }

    private static boolean isInOpenList(@Nullable Component focused) {
        Component list =
                focused instanceof JComboBox ? focused : SwingUtilities.getAncestorOfClass(JComboBox.class, focused);
        return list instanceof JComboBox<?> box && box.isPopupVisible();
    }

    @Override
    public void close() {
        queue.removeListener(pressedEarly);
        Toolkit.getDefaultToolkit().removeAWTEventListener(mouse);
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }
}
