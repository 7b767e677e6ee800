package majic.gui.bots;

import com.formdev.flatlaf.util.SystemInfo;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import majic.panel.KeyAction;
import majic.team.Member;

/**
 * The keys of the team strip. In the whole window Alt and a digit selects the robot of that number, 0 the tenth; digits
 * that follow within a second continue the number. On a card the arrow keys select the previous or the next robot, up
 * and down the one above or below where cards are in rows, and with Ctrl they only go there; Space adds the robot to
 * the selection or removes it, Ctrl A selects all, F2 renames the robot, and the menu key opens its menu.
 */
final class StripKeys {
    private static final int DIGITS = 10;
    private static final int LONGEST_NUMBER = 4;

    /** Up to this time after a digit, the next one continues the number. */
    private static final long CONTINUED_MS = 1000;

    private static final int CTRL = InputEvent.CTRL_DOWN_MASK;

    /** On a Mac, Alt and a digit type a sign. */
    private static final int NUMBERS = SystemInfo.isMacOS ? InputEvent.META_DOWN_MASK : InputEvent.ALT_DOWN_MASK;

    private final TeamStrip strip;
    private String digits = "";
    private long digitMs;

    private StripKeys(TeamStrip strip) {
        this.strip = strip;
    }

    static void bind(TeamStrip strip) {
        StripKeys keys = new StripKeys(strip);
        for (int digit = 0; digit < DIGITS; digit++) {
            String typed = "" + digit;
            KeyStroke key = KeyStroke.getKeyStroke(KeyEvent.VK_0 + digit, NUMBERS);
            KeyAction.bind(strip, JComponent.WHEN_IN_FOCUSED_WINDOW, key, event -> keys.typed(typed, event.getWhen()));
        }
        keys.bindArrows(() -> -strip.cardsToNextRow(), KeyEvent.VK_UP, KeyEvent.VK_KP_UP);
        keys.bindArrows(() -> -1, KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT);
        keys.bindArrows(strip::cardsToNextRow, KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN);
        keys.bindArrows(() -> 1, KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT);
        keys.bindOnCard(KeyEvent.VK_SPACE, 0, card -> strip.selection().toggle(card.member()));
        keys.bindOnCard(KeyEvent.VK_A, CTRL, card -> keys.selectAll());
        keys.bindOnCard(KeyEvent.VK_F2, 0, card -> strip.rename(card.member()));
        keys.bindOnCard(KeyEvent.VK_CONTEXT_MENU, 0, keys::showMenu);
        keys.bindOnCard(KeyEvent.VK_F10, InputEvent.SHIFT_DOWN_MASK, keys::showMenu);
    }

    private void bindArrows(IntSupplier step, int... codes) {
        for (int code : codes) {
            bindOnCard(
                    code,
                    0,
                    card -> strip.selection().select(go(card, step.getAsInt()).member()));
            bindOnCard(code, CTRL, card -> go(card, step.getAsInt()));
        }
    }

    private void bindOnCard(int code, int modifiers, Consumer<RobotCard> action) {
        KeyAction.bind(
                strip,
                JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT,
                KeyStroke.getKeyStroke(code, modifiers),
                event -> strip.cards().stream()
                        .filter(RobotCard::isFocusOwner)
                        .findFirst()
                        .ifPresent(action));
    }

    /**
     * Selects the robot of the number typed so far, or of the digit alone if there is no robot of the longer number.
     */
    private void typed(String digit, long atMs) {
        boolean continued = atMs - digitMs <= CONTINUED_MS && digits.length() < LONGEST_NUMBER;
        digits = continued && numbered(digits + digit).isPresent() ? digits + digit : digit;
        digitMs = atMs;
        numbered(digits).ifPresent(strip.selection()::select);
    }

    private Optional<Member> numbered(String typed) {
        int number = typed.equals("0") ? DIGITS : Integer.parseInt(typed);
        return strip.cards().stream()
                .map(RobotCard::member)
                .filter(member -> member.number() == number)
                .findFirst();
    }

    private void selectAll() {
        List<Member> all = strip.cards().stream().map(RobotCard::member).toList();
        strip.selection().set(all);
    }

    /** Moves the focus to a neighbour; returns that, or the same card at an end. */
    private RobotCard go(RobotCard from, int step) {
        List<RobotCard> cards = strip.cards();
        int index = Math.max(0, Math.min(cards.size() - 1, cards.indexOf(from) + step));
        RobotCard next = cards.get(index);
        next.setFocusable(true);
        next.requestFocusInWindow();
        return next;
    }

    private void showMenu(RobotCard card) {
        strip.showMenu(card.member(), card, card.getWidth() / 4, card.getHeight() / 2);
    }
}
