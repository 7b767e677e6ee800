package majic.gui.kit;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import javax.swing.UIManager;
import majic.bot.MajicBot;
import majic.panel.DrawingColors;
import majic.panel.ScaledIcon;
import majic.team.Member;
import majic.team.StopStatus;

/** Shows a robot's state as a small symbol that differs in shape as well as in colour. */
public enum StateIcon implements ScaledIcon {
    /** A filled disc: connected and stationary. */
    STATIONARY,
    /** A triangle: connected and moving. */
    MOVING,
    /** A ring: not connected yet. */
    WAITING,
    /** A cross: the connection is lost. */
    LOST,
    /** A filled triangle with an exclamation mark: the stop was not confirmed. */
    UNCONFIRMED;

    private static final int SIZE = 12;

    /** Returns the symbol of a robot, without the state of its stop. */
    public static StateIcon of(MajicBot bot) {
        return switch (bot.connection()) {
            case CONNECTED -> bot.state().moving() ? MOVING : STATIONARY;
            case NEW, CONNECTING -> WAITING;
            case LOST, CLOSED -> LOST;
        };
    }

    /** Returns the symbol of a robot of a team, with the state of its stop. */
    public static StateIcon of(Member member, StopStatus stops) {
        return stops.problem(member.number()).isPresent() ? UNCONFIRMED : of(member.bot());
    }

    @Override
    public void paint(Component on, Graphics2D g) {
        g.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        paint(g);
    }

    private void paint(Graphics2D g) {
        switch (this) {
            case STATIONARY -> {
                g.setColor(DrawingColors.current().good());
                g.fill(new Ellipse2D.Double(1, 1, 10, 10));
            }
            case MOVING -> {
                g.setColor(DrawingColors.current().accent());
                g.fill(new LineArt().area(2, 1, 11, 6, 2, 11).shape());
            }
            case WAITING -> {
                g.setColor(Palette.shape());
                g.draw(new Ellipse2D.Double(2, 2, 8, 8));
            }
            case LOST -> {
                g.setColor(Palette.error());
                g.draw(new Line2D.Double(2, 2, 10, 10));
                g.draw(new Line2D.Double(2, 10, 10, 2));
            }
            case UNCONFIRMED -> {
                g.setColor(Palette.error());
                g.fill(new LineArt().area(6, 0, 12, 11, 0, 11).shape());
                g.setStroke(new BasicStroke(1.4f));
                g.setColor(UIManager.getColor("Panel.background"));
                g.draw(new Line2D.Double(6, 4.5, 6, 7));
                g.draw(new Line2D.Double(6, 9.2, 6, 9.4));
            }
        }
    }

    @Override
    public int width() {
        return SIZE;
    }
}
