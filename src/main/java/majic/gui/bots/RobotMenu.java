package majic.gui.bots;

import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import majic.bot.MajicBot;
import majic.gui.kit.BotStatus;
import majic.team.Member;

/** The context menu of a robot. */
final class RobotMenu extends JPopupMenu {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the menu for the present state of a robot.
     *
     * @param openWindow shows its panel in a window of its own
     */
    RobotMenu(Member member, RobotActions actions, Consumer<Member> openWindow) {
        int number = member.number();
        setName("robotMenu");
        entry("Stop " + number, 'S', true, () -> actions.stop(member));
        boolean lost = member.bot().connection() == MajicBot.Connection.LOST;
        entry("Reconnect", 'R', lost, () -> actions.reconnect(member, () -> {}));
        if (actions.attempts(member).isPresent()) {
            entry("Cancel reconnecting", 'C', true, () -> actions.cancelReconnect(member));
        }
        addSeparator();
        entry("Load Act…", 'L', true, () -> actions.loadAct(member));
        entry("End Act", 'E', BotStatus.isInAct(member), () -> actions.endAct(member));
        addSeparator();
        entry("Open in a window", 'O', true, () -> openWindow.accept(member));
        addSeparator();
        entry("Kill Bot…", 'K', true, () -> actions.kill(member));
    }

    private void entry(String text, char mnemonic, boolean enabled, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setName(text);
        item.setMnemonic(mnemonic);
        item.setEnabled(enabled);
        item.addActionListener(event -> action.run());
        add(item);
    }
}
