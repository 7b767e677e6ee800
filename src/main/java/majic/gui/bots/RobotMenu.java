package majic.gui.bots;

import java.awt.event.KeyEvent;
import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import majic.bot.MajicBot;
import majic.gui.kit.BotStatus;
import majic.gui.kit.Mnemonics;
import majic.team.Member;
import majic.text.Texts;

/** The context menu of a robot. */
final class RobotMenu extends JPopupMenu {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RobotMenu.class);

    /**
     * Creates the menu for the present state of a robot.
     *
     * @param openWindow shows its panel in a window of its own
     */
    RobotMenu(Member member, RobotActions actions, Consumer<Member> openWindow) {
        setName("robotMenu");
        entry("stop", TEXTS.get("menu.stop", member.number()), true, () -> actions.stop(member));
        boolean lost = member.bot().connection() == MajicBot.Connection.LOST;
        entry("reconnect", TEXTS.get("menu.reconnect"), lost, () -> actions.reconnect(member, () -> {}));
        if (actions.attempts(member).isPresent()) {
            entry("cancelReconnect", TEXTS.get("menu.cancelReconnect"), true, () -> actions.cancelReconnect(member));
        }
        addSeparator();
        entry("loadAct", TEXTS.get("menu.loadAct"), true, () -> actions.loadAct(member));
        entry("endAct", TEXTS.get("menu.endAct"), BotStatus.isInAct(member), () -> actions.endAct(member));
        addSeparator();
        entry("rename", TEXTS.get("menu.rename"), true, () -> actions.rename(member, getInvoker()))
                .setAccelerator(KeyStroke.getKeyStroke(KeyEvent.VK_F2, 0));
        entry("openWindow", TEXTS.get("menu.openWindow"), true, () -> openWindow.accept(member));
        addSeparator();
        entry("kill", TEXTS.get("menu.kill"), true, () -> actions.kill(member));
        Mnemonics.assign(this);
    }

    private JMenuItem entry(String name, String text, boolean enabled, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setName(name);
        item.setEnabled(enabled);
        item.addActionListener(event -> action.run());
        return add(item);
    }
}
