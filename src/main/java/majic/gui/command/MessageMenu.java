package majic.gui.command;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Set;
import java.util.function.IntConsumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
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
        copy = item("copy", MessagePane.MENU_KEY + "C", () -> area.text().copy());
        onlyRobot = item("robot.this", "", this::showOnlyRobot);
        times.setName("messageTimes");
        times.addActionListener(event -> {
            area.showTimes(times.isSelected());
            timesChanged.run();
        });
        add(copy);
        add(item("copyAll", "", this::copyAll));
        add(item("find", MessagePane.MENU_KEY + "F", find));
        addSeparator();
        add(onlyRobot);
        add(times);
        add(item("larger", MessagePane.MENU_KEY + "PLUS", () -> sized.accept(1)));
        add(item("smaller", MessagePane.MENU_KEY + "MINUS", () -> sized.accept(-1)));
        add(item("usual", MessagePane.MENU_KEY + "0", () -> sized.accept(0)));
        addSeparator();
        add(item("clear", "", area::clear));
        addPopupMenuListener(new Opening());
    }

    /** Creates an entry; its key is only shown, since the pane has the keys. */
    private static JMenuItem item(String textKey, String key, Runnable action) {
        JMenuItem item = new JMenuItem(TEXTS.get(textKey));
        item.addActionListener(event -> action.run());
        item.setName(textKey);
        item.setAccelerator(key.isEmpty() ? null : KeyStroke.getKeyStroke(key));
        return item;
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
