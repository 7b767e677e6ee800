package majic.gui.bots;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import majic.gui.kit.BotStatus;
import majic.gui.kit.Palette;
import majic.gui.kit.StateIcon;
import majic.team.Member;
import majic.team.StopStatus;

/**
 * The icon of a robot's tab: the robot's state, followed by the Load Act icon while an act runs on it.
 *
 * @param condition the robot's state
 * @param act whether an act runs on it
 */
record TabIcon(StateIcon condition, boolean act) implements Icon {
    private static final int GAP = 5;
    private static final int SIGN = 11;

    static TabIcon of(Member member, StopStatus stops) {
        return new TabIcon(StateIcon.of(member, stops), BotStatus.isInAct(member));
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        condition.paintIcon(component, graphics, x, y);
        if (act) {
            Graphics2D g = (Graphics2D) graphics.create(x + condition.getIconWidth() + GAP, y, SIGN, getIconHeight());
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.setColor(Palette.text());
            g.draw(new Line2D.Double(1.5, 2, 1.5, 10));
            g.draw(triangle());
            g.dispose();
        }
    }

    private static Path2D triangle() {
        Path2D path = new Path2D.Double();
        path.moveTo(4.5, 2);
        path.lineTo(9.5, 6);
        path.lineTo(4.5, 10);
        path.closePath();
        return path;
    }

    @Override
    public int getIconWidth() {
        return condition.getIconWidth() + (act ? GAP + SIGN : 0);
    }

    @Override
    public int getIconHeight() {
        return condition.getIconHeight();
    }
}
