package majic.gui.start;

import java.awt.Component;
import java.awt.Container;
import java.awt.Font;
import java.awt.KeyboardFocusManager;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.Palette;
import majic.gui.kit.PlainLabel;
import majic.gui.kit.StyledLabel;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Offers what can be done while there is no robot. Must be used on the event dispatch thread. */
public final class StartPage extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StartPage.class);

    private final transient LastTeam lastTeam;
    private final transient StartActions actions;
    private final StartButton lab;
    private final StartButton team;
    private final transient List<StartButton> buttons;
    private final JLabel welcome = new StyledLabel("welcome", TEXTS.get("welcome"), Font.BOLD, 6);
    private final JLabel hint = new PlainLabel("startHint", TEXTS.get("hint"));

    /**
     * Creates the page.
     *
     * @param actions what the buttons do
     * @param lastTeam the team that the page offers again
     */
    public StartPage(StartActions actions, LastTeam lastTeam) {
        super(new MigLayout("insets 16, gap 6 8, wrap 1, alignx center, aligny center", "[320:420:460, fill]"));
        HelpTopic.set(this, "the-start-page");
        this.actions = actions;
        this.lastTeam = lastTeam;
        setName("startPage");
        lab = new StartButton(TEXTS.get("lab"), "", "lab", actions.startLab());
        team = new StartButton(TEXTS.get("team"), TEXTS.get("team.none"), "team", actions.openLastTeam());
        add(welcome);
        add(hint, "gapbottom 8");
        buttons = List.of(
                lab,
                new StartButton(TEXTS.get("robot"), TEXTS.get("robot.detail"), "add", actions.addBot()),
                team,
                new StartButton(TEXTS.get("session"), TEXTS.get("session.detail"), "session", actions.openSession()),
                new StartButton(TEXTS.get("tour"), TEXTS.get("tour.detail"), "tour", actions.startTour()));
        buttons.forEach(this::add);
        showTeam(List.of());
        lastTeam.onChange(this::showTeam);
        updateUI();
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

    /** Reads the pictures of the buttons from their files; may block. */
    public void readPictures() {
        buttons.forEach(StartButton::readPicture);
        EventThread.later(this::repaint);
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
}
