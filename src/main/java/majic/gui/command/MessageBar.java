package majic.gui.command;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.List;
import java.util.TreeSet;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.Palette;
import majic.gui.kit.TextChange;
import majic.panel.KeyAction;
import majic.text.Texts;

/** The controls above the messages: which robots and kinds are shown, and the search. */
final class MessageBar extends JPanel implements ClosesByEsc {
    private static final Texts TEXTS = Texts.of(MessageBar.class);
    private static final long serialVersionUID = 1L;

    private static final int GAP = 4;
    private static final int COUNT_WIDTH = 60;
    /** With more robots, the menu has submenus of as many. */
    private static final int MENU_LENGTH = 20;

    private final MessageArea area;
    private final transient MessageSearch search;
    private final transient Runnable toCommandLine;
    private final JButton robots = new JButton();
    private final JButton kinds = new JButton();
    private final JButton unseen = new JButton();
    private final JTextField find = new JTextField(14) {
        private static final long serialVersionUID = 1L;

        @Override
        public Dimension getMaximumSize() {
            return getPreferredSize();
        }
    };
    private final JLabel count = new JLabel() {
        private static final long serialVersionUID = 1L;

        @Override
        public Dimension getPreferredSize() {
            Dimension text = super.getPreferredSize();
            return new Dimension(Math.max(UIScale.scale(COUNT_WIDTH), text.width), text.height);
        }
    };
    private final JButton previous = button("\u2191", TEXTS.get("find.previous"));
    private final JButton next = button("\u2193", TEXTS.get("find.next"));

    /**
     * Creates the controls of an area.
     *
     * @param toCommandLine gives the focus to the command line
     */
    MessageBar(MessageArea area, Runnable toCommandLine) {
        setLayout(new BoxLayout(this, BoxLayout.X_AXIS));
        this.area = area;
        this.toCommandLine = toCommandLine;
        search = new MessageSearch(area);
        prepare(robots, "messageRobots", TEXTS.get("robots.hint"));
        prepare(kinds, "messageKinds", TEXTS.get("kinds.hint"));
        prepare(unseen, "newMessages", TEXTS.get("new.hint"));
        unseen.setRequestFocusEnabled(false);
        unseen.addActionListener(event -> area.showNewest());
        robots.addActionListener(event -> robotMenu().show(robots, 0, robots.getHeight()));
        kinds.addActionListener(event -> kindMenu().show(kinds, 0, kinds.getHeight()));
        prepareFind();
        previous.addActionListener(event -> move(-1));
        next.addActionListener(event -> move(1));
        place();
        update();
    }

    private void place() {
        List.of(robots, kinds).forEach(this::addWithGap);
        add(Box.createHorizontalGlue());
        addWithGap(unseen);
        List.of(find, count, previous, next).forEach(this::addWithGap);
    }

    private void addWithGap(JComponent component) {
        add(component);
        add(Box.createHorizontalStrut(UIScale.scale(GAP)));
    }

    private static void prepare(JButton button, String name, String purpose) {
        button.setName(name);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setToolTipText(purpose);
        button.getAccessibleContext().setAccessibleDescription(purpose);
    }

    private static JButton button(String sign, String purpose) {
        JButton button = new JButton(sign);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setToolTipText(purpose);
        button.getAccessibleContext().setAccessibleName(purpose);
        return button;
    }

    private void prepareFind() {
        find.setName("findMessage");
        find.putClientProperty("JTextField.placeholderText", TEXTS.get("find.hint"));
        find.getAccessibleContext().setAccessibleName(TEXTS.get("find.field"));
        count.setName("foundCount");
        find.addActionListener(event -> move(-1));
        find.getDocument().addDocumentListener(new TextChange(this::findText));
    }

    /** Adds the keys of the search. */
    void complete() {
        KeyAction.bind(find, WHEN_FOCUSED, KeyStroke.getKeyStroke("shift ENTER"), event -> move(1));
        KeyAction.bind(find, WHEN_FOCUSED, KeyStroke.getKeyStroke("ESCAPE"), event -> endFind());
    }

    /** Gives the focus to the field for the search. */
    void startFind() {
        find.requestFocusInWindow();
        find.selectAll();
    }

    private void endFind() {
        find.setText("");
        toCommandLine.run();
    }

    private void findText() {
        // Made with the first letter, since making it delays the window.
        find.putClientProperty("JTextField.showClearButton", true);
        search.find(find.getText());
        showCount();
    }

    /** Selects the previous or the next place found. */
    void move(int step) {
        search.move(step);
        showCount();
    }

    private void showCount() {
        count.setText(search.count());
        previous.setEnabled(!find.getText().isEmpty());
        next.setEnabled(!find.getText().isEmpty());
    }

    /** Follows a change of the messages or the filter. */
    void update() {
        MessageFilter filter = area.filter();
        robots.setText(MessageFilter.label(filter.robot()) + " \u25be");
        boolean all = filter.shown().size() == MessageFilter.Group.values().length;
        kinds.setText((all ? TEXTS.get("kinds.all") : TEXTS.get("kinds.some")) + " \u25be");
        showUnseen();
        search.repeat();
        showCount();
    }

    /** Shows the marker, which takes free space of the bar, so that nothing else moves. */
    private void showUnseen() {
        MessageArea.Unseen now = area.unseen();
        unseen.setVisible(now.lines() > 0);
        unseen.setText(TEXTS.get(now.alarm() ? "new.alarm" : "new", now.lines()));
        unseen.setBackground(now.alarm() ? Palette.error() : null);
        unseen.setForeground(now.alarm() ? Palette.paper() : null);
    }

    private JPopupMenu robotMenu() {
        JPopupMenu menu = new JPopupMenu();
        menu.add(robotItem(MessageFilter.ALL_ROBOTS));
        List<Integer> numbers = List.copyOf(new TreeSet<>(area.robots()));
        if (numbers.size() <= MENU_LENGTH) {
            numbers.forEach(number -> menu.add(robotItem(number)));
            return menu;
        }
        for (int begin = 0; begin < numbers.size(); begin += MENU_LENGTH) {
            List<Integer> part = numbers.subList(begin, Math.min(numbers.size(), begin + MENU_LENGTH));
            JMenu submenu = new JMenu(part.get(0) + " – " + part.get(part.size() - 1));
            part.forEach(number -> submenu.add(robotItem(number)));
            menu.add(submenu);
        }
        return menu;
    }

    private JMenuItem robotItem(int number) {
        JMenuItem item =
                new JCheckBoxMenuItem(MessageFilter.label(number), area.filter().robot() == number);
        item.addActionListener(event -> area.show(area.filter().forRobot(number)));
        return item;
    }

    private JPopupMenu kindMenu() {
        JPopupMenu menu = new JPopupMenu();
        for (MessageFilter.Group group : MessageFilter.Group.values()) {
            JCheckBoxMenuItem item =
                    new JCheckBoxMenuItem(group.label(), area.filter().shown().contains(group));
            item.addActionListener(event -> area.show(area.filter().with(group, item.isSelected())));
            menu.add(item);
        }
        JMenuItem note = new JMenuItem(TEXTS.get("kinds.always"));
        note.setEnabled(false);
        menu.addSeparator();
        menu.add(note);
        return menu;
    }

    /** Returns true while the search has the focus: Esc ends it. */
    @Override
    public boolean hasToClose() {
        return find.isFocusOwner();
    }
}
