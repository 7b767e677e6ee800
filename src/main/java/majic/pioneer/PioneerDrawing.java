package majic.pioneer;

import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JPanel;
import majic.panel.Ink;
import org.jspecify.annotations.Nullable;

/**
 * A Pioneer from above, looking up, to scale, amid its sonar cones and rings at round distances. In little room it shows
 * less of the surroundings rather than a tiny robot. For the event thread.
 */
final class PioneerDrawing extends JPanel {
    private static final long serialVersionUID = 1;

    /** The robot is drawn at least this large, as long as that leaves {@link #LEAST_REACH_MM} around it. */
    private static final double PX_PER_MM = 0.08;

    private static final double LEAST_REACH_MM = 1500;
    private static final double MOST_REACH_MM = 3200;

    private transient @Nullable PioneerScene scene;

    PioneerDrawing() {
        setOpaque(false);
        getAccessibleContext().setAccessibleName("the Pioneer from above with its sonar readings");
        setToolTipText("Cones are sonar beams as far as they heard nothing, bars at their ends are echoes");
    }

    void show(PioneerScene newScene) {
        scene = newScene;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        PioneerScene shown = scene;
        if (shown == null) {
            return;
        }
        Graphics2D pen = (Graphics2D) graphics.create();
        Ink.prepare(pen);
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        double side = Math.max(1, Math.min(getWidth(), getHeight()));
        double reach = Math.max(LEAST_REACH_MM, Math.min(MOST_REACH_MM, side / 2 / PX_PER_MM));
        double pxPerMm = side / 2 / reach;
        Ink ink = shown.connected() ? Ink.ofTheLook() : Ink.ofTheLook().faded();
        paintWorld(pen, shown, ink, pxPerMm);
        new RingsDrawing(ink, pxPerMm).paint(pen, reach);
        paintRobot(pen, shown, ink, pxPerMm);
        pen.dispose();
    }

    private static void paintWorld(Graphics2D pen, PioneerScene shown, Ink ink, double pxPerMm) {
        Graphics2D robotFrame = robotFrame(pen, pxPerMm);
        new ConesDrawing(shown.state().sonar(), ink, pxPerMm)
                .paint(robotFrame, shown.model().discs());
        robotFrame.dispose();
    }

    private static void paintRobot(Graphics2D pen, PioneerScene shown, Ink ink, double pxPerMm) {
        Graphics2D robotFrame = robotFrame(pen, pxPerMm);
        new BodyDrawing(shown, ink, pxPerMm).paint(robotFrame);
        robotFrame.dispose();
    }

    /** The robot's own axes in mm: x up, y to the left. */
    private static Graphics2D robotFrame(Graphics2D pen, double pxPerMm) {
        Graphics2D robotFrame = (Graphics2D) pen.create();
        robotFrame.rotate(-Math.PI / 2);
        robotFrame.scale(pxPerMm, -pxPerMm);
        return robotFrame;
    }
}
