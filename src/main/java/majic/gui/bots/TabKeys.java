package majic.gui.bots;

import com.formdev.flatlaf.util.SystemInfo;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.IntSupplier;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import majic.panel.KeyAction;

/**
 * The keys of the tabs of robots. In the whole window Alt and a digit selects the robot of that number, 0 the tenth;
 * digits that follow within a second continue the number. Ctrl and Page Up or Page Down selects the previous or the
 * next robot. On a tab the arrow keys select the neighbour in that direction, and with Ctrl they only go there; Space
 * adds the robot to the selection or removes it, Ctrl A selects all, F2 renames the robot, and the menu key opens its
 * menu.
 */
final class TabKeys {
    private static final int DIGITS = 10;
    private static final int LONGEST_NUMBER = 4;

    /** Up to this time after a digit, the next one continues the number. */
    private static final long CONTINUED_MS = 1000;

    private static final int CTRL = InputEvent.CTRL_DOWN_MASK;

    /** On a Mac, Alt and a digit type a sign. */
    private static final int NUMBERS = SystemInfo.isMacOS ? InputEvent.META_DOWN_MASK : InputEvent.ALT_DOWN_MASK;

    private final RobotTabs tabs;
    private String digits = "";
    private long digitMs;

    private TabKeys(RobotTabs tabs) {
        this.tabs = tabs;
    }

    /** Binds the keys that work in the whole window. */
    static void bind(RobotTabs tabs) {
        TabKeys keys = new TabKeys(tabs);
        for (int digit = 0; digit < DIGITS; digit++) {
            String typed = "" + digit;
            KeyStroke key = KeyStroke.getKeyStroke(KeyEvent.VK_0 + digit, NUMBERS);
            KeyAction.bind(tabs, JComponent.WHEN_IN_FOCUSED_WINDOW, key, event -> keys.typed(typed, event.getWhen()));
        }
        keys.bindPages(KeyEvent.VK_PAGE_UP, -1);
        keys.bindPages(KeyEvent.VK_PAGE_DOWN, 1);
    }

    /** Binds the keys that work while a tab has the focus. */
    static void bind(RobotTabs tabs, RobotTab tab) {
        TabKeys keys = new TabKeys(tabs);
        keys.bindArrows(tab, () -> -tabs.columns().grid().toTabBelow(), KeyEvent.VK_UP, KeyEvent.VK_KP_UP);
        keys.bindArrows(tab, () -> -tabs.columns().grid().toTabBeside(), KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT);
        keys.bindArrows(tab, () -> tabs.columns().grid().toTabBelow(), KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN);
        keys.bindArrows(tab, () -> tabs.columns().grid().toTabBeside(), KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT);
        keys.bindOnTab(tab, KeyEvent.VK_SPACE, 0, () -> tabs.toggle(tab));
        keys.bindOnTab(tab, KeyEvent.VK_A, CTRL, tabs::chooseAll);
        keys.bindOnTab(tab, KeyEvent.VK_F2, 0, () -> tabs.rename(tab));
        keys.bindOnTab(tab, KeyEvent.VK_CONTEXT_MENU, 0, () -> keys.showMenu(tab));
        keys.bindOnTab(tab, KeyEvent.VK_F10, InputEvent.SHIFT_DOWN_MASK, () -> keys.showMenu(tab));
    }

    private void bindPages(int code, int step) {
        KeyAction.bind(
                tabs, JComponent.WHEN_IN_FOCUSED_WINDOW, KeyStroke.getKeyStroke(code, CTRL), event -> chooseNext(step));
    }

    /** Selects the robot before or after the selected one; behind the last one comes the first. */
    private void chooseNext(int step) {
        List<RobotTab> all = tabs.tabs();
        if (!all.isEmpty()) {
            int selected = tabs.getSelectedIndex();
            int from = selected < 0 && step < 0 ? 0 : selected;
            tabs.choose(all.get(Math.floorMod(from + step, all.size())));
        }
    }

    private void bindArrows(RobotTab tab, IntSupplier step, int... codes) {
        for (int code : codes) {
            bindOnTab(tab, code, 0, () -> tabs.choose(go(tab, step.getAsInt())));
            bindOnTab(tab, code, CTRL, () -> go(tab, step.getAsInt()));
        }
    }

    private void bindOnTab(RobotTab tab, int code, int modifiers, Runnable action) {
        KeyStroke key = KeyStroke.getKeyStroke(code, modifiers);
        KeyAction.bind(tab, JComponent.WHEN_FOCUSED, key, event -> action.run());
    }

    /**
     * Selects the robot of the number typed so far, or of the digit alone if there is no robot of the longer number.
     */
    private void typed(String digit, long atMs) {
        boolean continued = atMs - digitMs <= CONTINUED_MS && digits.length() < LONGEST_NUMBER;
        digits = continued && numbered(digits + digit).isPresent() ? digits + digit : digit;
        digitMs = atMs;
        numbered(digits).ifPresent(tabs::choose);
    }

    private Optional<RobotTab> numbered(String typed) {
        int number = typed.equals("0") ? DIGITS : Integer.parseInt(typed);
        return tabs.tabs().stream().filter(tab -> tab.number() == number).findFirst();
    }

    /** Moves the focus to a neighbour; returns that, or the same tab if there is none in this direction. */
    private RobotTab go(RobotTab from, int step) {
        List<RobotTab> all = tabs.tabs();
        int index = all.indexOf(from) + step;
        RobotTab next = index < 0 || index >= all.size() ? from : all.get(index);
        next.setFocusable(true);
        next.requestFocusInWindow();
        return next;
    }

    private void showMenu(RobotTab tab) {
        tabs.showMenu(tab, tab, tab.getWidth() / 4, tab.getHeight() / 2);
    }
}
