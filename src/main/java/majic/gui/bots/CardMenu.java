package majic.gui.bots;

import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import majic.bot.MajicBot;
import majic.gui.kit.BotStatus;
import majic.team.Member;

/** The context menu of a robot. */
final class CardMenu extends JPopupMenu {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the menu for the present state of a robot.
     *
     * @param openWindow shows its panel in a window of its own
     */
    CardMenu(Member member, RobotActions actions, Consumer<Member> openWindow) {
        int number = member.number();
        setName("robotMenu");
        entry("Stop " + number, true, () -> actions.stop(member));
        boolean lost = member.bot().connection() == MajicBot.Connection.LOST;
        entry("Reconnect", lost, () -> actions.reconnect(member, () -> {}));
        if (actions.attempts(member).isPresent()) {
            entry("Cancel reconnecting", true, () -> actions.cancelReconnect(member));
        }
        addSeparator();
        entry("Load Act…", true, () -> actions.loadAct(member));
        entry("End Act", BotStatus.isInAct(member), () -> actions.endAct(member));
        addSeparator();
        entry("Open in a window", true, () -> openWindow.accept(member));
        addSeparator();
        entry("Kill Bot…", true, () -> actions.kill(member));
    }

    private void entry(String text, boolean enabled, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setName(text);
        item.setEnabled(enabled);
        item.addActionListener(event -> action.run());
        add(item);
    }
}
