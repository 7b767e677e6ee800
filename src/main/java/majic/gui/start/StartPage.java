package majic.gui.start;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.KeyboardFocusManager;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.gui.kit.Pictogram;
import majic.gui.kit.StyledLabel;
import majic.text.Texts;

/** Offers what can be done while there is no robot. Must be used on the event dispatch thread. */
public final class StartPage extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StartPage.class);

    private final transient LastTeam lastTeam;
    private final transient StartActions actions;
    private final StartButton lab;
    private final StartButton team;
    private final transient List<StartButton> buttons;
    private final JPanel column = new Column();
    private final JLabel welcome = new StyledLabel("welcome", TEXTS.get("welcome"), Font.BOLD, 6);
    private final JLabel hint = new NamedLabel("startHint", TEXTS.get("hint"));

    /**
     * Creates the page.
     *
     * @param actions what the buttons do
     * @param lastTeam the team that the page offers again
     */
    public StartPage(StartActions actions, LastTeam lastTeam) {
        super(new GridBagLayout());
        HelpTopic.set(this, "the-start-page");
        this.actions = actions;
        this.lastTeam = lastTeam;
        setName("startPage");
        lab = new StartButton(TEXTS.get("lab"), "", Pictogram.LAB, actions.startLab());
        team = new StartButton(TEXTS.get("team"), TEXTS.get("team.none"), Pictogram.TEAM, actions.openLastTeam());
        buttons = List.of(
                lab,
                new StartButton(TEXTS.get("robot"), TEXTS.get("robot.detail"), Pictogram.ADD, actions.addBot()),
                team,
                new StartButton(
                        TEXTS.get("session"), TEXTS.get("session.detail"), Pictogram.SESSION, actions.openSession()),
                new StartButton(TEXTS.get("tour"), TEXTS.get("tour.detail"), Pictogram.TOUR, actions.startTour()));
        addBelow(welcome, 8);
        addBelow(hint, 16);
        buttons.forEach(button -> addBelow(button, 8));
        add(column);
        showTeam(List.of());
        lastTeam.onChange(this::showTeam);
        updateUI();
    }

    private void addBelow(JComponent part, int gap) {
        GridBagConstraints row = new GridBagConstraints();
        row.gridx = 0;
        row.weightx = 1;
        row.fill = GridBagConstraints.HORIZONTAL;
        row.insets = new Insets(0, 0, gap, 0);
        column.add(part, row);
    }

    /**
     * Shows the explanations of the buttons as long as there is room for all buttons; otherwise their tool tips have
     * them.
     */
    @Override
    public void doLayout() {
        int details = buttons.stream().mapToInt(StartButton::hiddenHeight).sum();
        boolean room = column.getPreferredSize().height + details <= getHeight();
        buttons.forEach(button -> button.showDetail(room));
        super.doLayout();
    }

    private void showTeam(List<String> names) {
        team.setEnabled(!names.isEmpty());
        team.describe(names.isEmpty() ? TEXTS.get("team.none") : String.join(", ", names));
    }

    /** Shows whether the lab can be started; called before the page is shown. */
    private void showLab() {
        boolean can = actions.canStartLab().getAsBoolean();
        lab.setEnabled(can);
        lab.describe(TEXTS.get(can ? "lab.detail" : "lab.running"));
    }

    @Override
    public void addNotify() {
        super.addNotify();
        showLab();
        lastTeam.read();
    }

    @Override
    public void setVisible(boolean visible) {
        if (!visible) {
            leaveFocus();
        }
        super.setVisible(visible);
        if (visible) {
            showLab();
        }
    }

    /** Moves the focus from the button that was pressed to the window's default component. */
    private void leaveFocus() {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        Container window = getFocusCycleRootAncestor();
        if (focused != null && window != null && SwingUtilities.isDescendingFrom(focused, this)) {
            window.getFocusTraversalPolicy().getDefaultComponent(window).requestFocusInWindow();
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (hint != null) {
            hint.setForeground(Palette.faint());
        }
    }

    /** The parts below each other, in a width that is easy to read. */
    private static final class Column extends JPanel {
        private static final long serialVersionUID = 1L;
        private static final int WIDTH = 420;
        private static final int LEAST_WIDTH = 320;

        Column() {
            super(new GridBagLayout());
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(UIScale.scale(WIDTH), super.getPreferredSize().height);
        }

        @Override
        public Dimension getMinimumSize() {
            return new Dimension(UIScale.scale(LEAST_WIDTH), super.getPreferredSize().height);
        }
    }
}
