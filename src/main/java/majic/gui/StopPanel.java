package majic.gui;

import java.awt.Color;
import java.awt.Font;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.bot.Team;
import majic.bot.TeamListener;
import net.miginfocom.swing.MigLayout;

/** The large red STOP for all robots, and beside it the button that allows motion again. */
final class StopPanel extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Color RED = new Color(0xC62828);
    private static final Color DARK_RED = new Color(0x7F1D1D);

    private final JButton stop = new JButton();
    private final JButton release = new JButton("Release");

    StopPanel(Team team) {
        super(new MigLayout("insets 0, gap 6, hidemode 3", "[][]", "[fill]"));
        stop.setName("stop");
        stop.setFocusable(false);
        stop.setForeground(Color.WHITE);
        stop.setFont(stop.getFont().deriveFont(Font.BOLD, stop.getFont().getSize2D() * 1.25f));
        stop.putClientProperty("JButton.buttonType", "roundRect");
        stop.setToolTipText("Stops every robot at once; works in every window of MAJIC by Esc and F12");
        stop.addActionListener(event -> team.stopAll());
        release.setName("release");
        release.setToolTipText("Allows motion again; nothing resumes by itself");
        release.addActionListener(event -> team.release());
        add(release, "h 52!");
        add(stop, "w 170!, h 52!");
        latchChanged(team.isLatched());
    }

    @Override
    public void latchChanged(boolean latched) {
        stop.setText(label(latched ? "STOPPED" : "STOP", latched ? "until released" : "Esc or F12"));
        stop.setBackground(latched ? DARK_RED : RED);
        stop.getAccessibleContext().setAccessibleName(latched ? "Stopped; stop again" : "Stop all robots");
        release.setVisible(latched);
    }

    private static String label(String word, String below) {
        return "<html><center><b>" + word + "</b><br><span style='font-size:75%'>" + below + "</span></center></html>";
    }
}
