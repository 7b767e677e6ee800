package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.KeyboardFocusManager;
import java.beans.PropertyChangeListener;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.ClearOfStop;
import majic.gui.kit.EventThread;
import majic.gui.kit.StyledLabel;
import majic.team.StopOrigin;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.Texts;
import majic.time.WaitPolicy;

/** Shows the large red STOP for all robots, and beside it the button that permits motion again. */
final class StopPanel extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StopPanel.class);
    private static final Color RED = new Color(0xC62828);
    private static final int STOP_WIDTH = 170;
    private static final int HGAP = 6;
    private static final String FOCUSED = "focusedWindow";
    private static final Color DARK_RED = new Color(0x7F1D1D);

    private final transient Team team;
    private final JButton stop = new JButton() {
        private static final long serialVersionUID = 1L;

        @Override
        public Dimension getPreferredSize() {
            return UIScale.scale(new Dimension(STOP_WIDTH, FrameToolbar.BUTTON_HEIGHT));
        }
    };
    private final JLabel word = new StyledLabel("stopWord", "", Font.BOLD, 6);
    private final JLabel below = new JLabel();
    private final transient PropertyChangeListener focus = event -> EventThread.later(this::showLatch);
    private final JButton release = new JButton(TEXTS.get("release"));

    /**
     * Creates the buttons.
     *
     * @param stopAll stops all robots
     */
    StopPanel(Team team, Runnable stopAll) {
        super(new BorderLayout(HGAP, 0));
        stop.setName("stop");
        stop.setFocusable(false);
        ClearOfStop.mark(stop);
        GridBagConstraints oneColumn = new GridBagConstraints();
        oneColumn.gridx = 0;
        stop.setLayout(new GridBagLayout());
        stop.add(word, oneColumn);
        stop.add(below, oneColumn);
        word.setForeground(Color.WHITE);
        below.setName("stopCount");
        below.setForeground(Color.WHITE);
        stop.putClientProperty("JButton.buttonType", "roundRect");
        stop.addActionListener(event -> stopAll.run());
        release.setName("release");
        release.setToolTipText(TEXTS.get("release.tip"));
        release.addActionListener(event -> WaitPolicy.without(team::release));
        add(release, BorderLayout.WEST);
        add(stop, BorderLayout.EAST);
        this.team = team;
        showLatch();
    }

    /** Returns the preferred width with the button that permits motion again, in pixels. */
    int widestWidth() {
        int beside = release.isVisible() ? 0 : release.getPreferredSize().width + HGAP;
        return getPreferredSize().width + beside;
    }

    /** Begins to show whether the keys reach this program. */
    @Override
    public void addNotify() {
        super.addNotify();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener(FOCUSED, focus);
        showLatch();
    }

    @Override
    public void removeNotify() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removePropertyChangeListener(FOCUSED, focus);
        super.removeNotify();
    }

    /** Shows the team's present state rather than the event's, because events may arrive late. */
    @Override
    public void latchChanged(boolean then) {
        showLatch();
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        showLatch();
    }

    private void showLatch() {
        boolean latched = team.isLatched();
        StopStatus status = team.stopStatus();
        word.setText(TEXTS.get(latched ? "stopped" : "stop"));
        below.setText(latched ? receipt(status) : keys());
        stop.setBackground(latched ? DARK_RED : RED);
        stop.getAccessibleContext()
                .setAccessibleName(latched ? TEXTS.get("stopped.name", confirmed(status)) : TEXTS.get("stop.name"));
        stop.setToolTipText(tip(team.stopOrigin()));
        release.setVisible(latched);
    }

    /** Begins with the user and the desk at which STOP was pressed, if it was another one. */
    private static String tip(Optional<StopOrigin> origin) {
        String tip = TEXTS.get("stop.tip");
        return origin.map(from -> TEXTS.get(from.time() == null ? "stop.by" : "stop.byAt", from.by(), from.timeText())
                        + " " + tip)
                .orElse(tip);
    }

    private static String keys() {
        return TEXTS.get(keysReachMajic() ? "keys" : "keys.elsewhere");
    }

    private static boolean keysReachMajic() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow() != null;
    }

    /** Returns the count, shortened to make room for the hint that the keys do not reach this program. */
    private static String receipt(StopStatus status) {
        if (!status.elsewhere().isEmpty()) {
            return confirmed(status);
        }
        if (keysReachMajic() || status.asked() == 0) {
            return keysReachMajic() ? confirmed(status) : TEXTS.get("keys.elsewhere");
        }
        return TEXTS.get("confirmed.keysElsewhere", status.confirmed(), status.asked());
    }

    private static String confirmed(StopStatus status) {
        if (!status.elsewhere().isEmpty()) {
            return TEXTS.get("confirmed.here", status.confirmed(), status.asked());
        }
        return status.asked() == 0
                ? TEXTS.get("untilReleased")
                : TEXTS.get("confirmed", status.confirmed(), status.asked());
    }
}
