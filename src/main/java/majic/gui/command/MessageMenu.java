package majic.gui.command;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Set;
import java.util.function.IntConsumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.event.PopupMenuEvent;
import javax.swing.event.PopupMenuListener;
import majic.text.Texts;

/** The context menu of the messages. */
final class MessageMenu extends JPopupMenu {
    private static final Texts TEXTS = Texts.of(MessageMenu.class);
    private static final long serialVersionUID = 1L;

    private final MessageArea area;
    private final JMenuItem copy;
    private final JMenuItem onlyRobot;
    private final JCheckBoxMenuItem times = new JCheckBoxMenuItem(TEXTS.get("times"));

    /**
     * Creates the menu of an area.
     *
     * @param find starts the search
     * @param sized receives by how much the text gets larger, points; 0 for the usual size
     * @param timesChanged receives whether the times are shown
     */
    MessageMenu(MessageArea area, Runnable find, IntConsumer sized, Runnable timesChanged) {
        this.area = area;
        copy = MenuEntry.of(
                "copy", MessagePane.MENU_KEY + "C", () -> area.text().copy());
        onlyRobot = MenuEntry.of("robot.this", "", this::showOnlyRobot);
        times.setName("messageTimes");
        times.addActionListener(event -> {
            area.showTimes(times.isSelected());
            timesChanged.run();
        });
        add(copy);
        add(MenuEntry.of("copyAll", "", this::copyAll));
        add(MenuEntry.of("find", MessagePane.MENU_KEY + "F", find));
        addSeparator();
        add(onlyRobot);
        add(times);
        add(MenuEntry.of("larger", MessagePane.MENU_KEY + "PLUS", () -> sized.accept(1)));
        add(MenuEntry.of("smaller", MessagePane.MENU_KEY + "MINUS", () -> sized.accept(-1)));
        add(MenuEntry.of("usual", MessagePane.MENU_KEY + "0", () -> sized.accept(0)));
        addSeparator();
        add(MenuEntry.of("clear", "", area::clear));
        addPopupMenuListener(new Opening());
    }

    private void copyAll() {
        Toolkit.getDefaultToolkit()
                .getSystemClipboard()
                .setContents(new StringSelection(area.text().getText()), null);
    }

    /** Shows all robots again, or only the one that the message under the mouse is of. */
    private void showOnlyRobot() {
        boolean all = area.filter().robot() == MessageFilter.ALL_ROBOTS;
        area.show(area.filter().forRobot(all ? robot() : MessageFilter.ALL_ROBOTS));
    }

    private int robot() {
        Set<Integer> robots = area.isEmpty()
                ? Set.of()
                : area.messageAt(area.text().menuOffset()).robots();
        return robots.stream().findFirst().orElse(MessageFilter.ALL_ROBOTS);
    }

    private final class Opening implements PopupMenuListener {
        @Override
        public void popupMenuWillBecomeVisible(PopupMenuEvent event) {
            copy.setEnabled(area.text().getSelectedText() != null);
            times.setSelected(area.hasTimes());
            boolean all = area.filter().robot() == MessageFilter.ALL_ROBOTS;
            int robot = robot();
            boolean named = robot != MessageFilter.ALL_ROBOTS;
            onlyRobot.setText(
                    all && !named
                            ? TEXTS.get("robot.this")
                            : MessageFilter.label(all ? robot : MessageFilter.ALL_ROBOTS));
            onlyRobot.setEnabled(!all || named);
        }

        @Override
        public void popupMenuWillBecomeInvisible(PopupMenuEvent event) {}

        @Override
        public void popupMenuCanceled(PopupMenuEvent event) {}
    }
}
