package majic.gui.kit;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import javax.swing.JButton;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.Texts;

/** The STOP button of the windows beside the main one. Stops all robots; shows whether STOP is latched. */
public final class StopButton extends JButton {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StopButton.class);
    private static final Color RED = new Color(0xC62828);
    private static final Color DARK_RED = new Color(0x7F1D1D);

    private final transient Team team;
    private final transient TeamListener listener = new EventThreadTeamListener(new Latch());

    /**
     * Creates the button.
     *
     * @param stopAll stops all robots
     */
    public StopButton(Team team, Runnable stopAll) {
        this.team = team;
        setName("smallStop");
        setFocusable(false);
        setForeground(Color.WHITE);
        putClientProperty("JButton.buttonType", "roundRect");
        putClientProperty("FlatLaf.style", "font: bold +4");
        setToolTipText(TEXTS.get("stop.tip"));
        addActionListener(event -> stopAll.run());
        showLatch();
    }

    /** Begins to follow the team. */
    @Override
    public void addNotify() {
        super.addNotify();
        team.addListener(listener);
        showLatch();
    }

    @Override
    public void removeNotify() {
        team.removeListener(listener);
        super.removeNotify();
    }

    /** Returns a size in which both of its texts have room, so that no other button moves while STOP is pressed. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        FontMetrics metrics = getFontMetrics(getFont());
        int longest = Math.max(metrics.stringWidth(TEXTS.get("stop")), metrics.stringWidth(TEXTS.get("stopped")));
        return new Dimension(size.width + longest - metrics.stringWidth(getText()), size.height);
    }

    private void showLatch() {
        boolean latched = team.isLatched();
        setText(TEXTS.get(latched ? "stopped" : "stop"));
        setBackground(latched ? DARK_RED : RED);
        getAccessibleContext().setAccessibleName(TEXTS.get(latched ? "stopped.name" : "stop.name"));
    }

    /** Shows the team's present state rather than the event's, because events may arrive late. */
    private final class Latch implements TeamListener {
        @Override
        public void latchChanged(boolean then) {
            showLatch();
        }
    }
}
