package majic.aibo.panel;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import javax.swing.JPanel;
import majic.aibo.body.DogState;
import majic.panel.DrawingColors;

/**
 * Draws the dog three times with its joints as they were measured: from its right, from above with what its distance
 * sensors meet, and its face. As large as the room allows; faded while disabled. For the event thread.
 */
final class DogDrawing extends JPanel {
    private static final long serialVersionUID = 1;

    /** Wider than this for its height, and all three stand in a row. */
    private static final double WIDE = 2.1;

    /** Higher than this for its width, and all three stand below each other. */
    private static final double NARROW = 1.3;

    /** Of the room from above: how far from its foot the head turns, and how far the beams reach beyond. */
    private static final double HEAD_AT = 0.55;

    private static final double REACH = 0.43;
    private static final double NOSE_MM = 104;
    private static final double BEHIND_HEAD_MM = 270;

    private final transient DogState dog;

    DogDrawing(DogState dog) {
        this.dog = dog;
        setOpaque(false);
        getAccessibleContext().setAccessibleName("the Aibo from its side, from above, and its face");
        setToolTipText("Rings: how far the infra-red sensors see. Blue pads are pressed, blue paws on the ground.");
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        int width = getWidth();
        int height = getHeight();
        if (width > WIDE * height) {
            int each = (int) (0.36 * width);
            paintSide(part(pen, new Rectangle(0, 0, each, height)));
            paintAbove(part(pen, new Rectangle(each, 0, each, height)));
            paintFace(part(pen, new Rectangle(2 * each, 0, width - 2 * each, height)));
        } else if (height > NARROW * width) {
            int side = (int) (0.35 * height);
            int face = (int) (0.26 * height);
            paintSide(part(pen, new Rectangle(0, 0, width, side)));
            paintAbove(part(pen, new Rectangle(0, side, width, height - side - face)));
            paintFace(part(pen, new Rectangle(0, height - face, width, face)));
        } else {
            int side = (int) (0.46 * height);
            int above = (int) (0.6 * width);
            paintSide(part(pen, new Rectangle(0, 0, width, side)));
            paintAbove(part(pen, new Rectangle(0, side, above, height - side)));
            paintFace(part(pen, new Rectangle(above, side, width - above, height - side)));
        }
        pen.dispose();
    }

    private static Graphics2D part(Graphics2D pen, Rectangle room) {
        return (Graphics2D) pen.create(room.x, room.y, room.width, room.height);
    }

    private DrawingColors colors() {
        return isEnabled() ? DrawingColors.current() : DrawingColors.current().faded();
    }

    private void paintSide(Graphics2D pen) {
        double width = pen.getClipBounds().getWidth();
        double height = pen.getClipBounds().getHeight();
        double length = FigureDrawing.AHEAD_MM + FigureDrawing.REAR_MM;
        double scale = Math.min(width / length, height / (FigureDrawing.HIGH_MM + 16));
        pen.translate(width / 2 + (FigureDrawing.REAR_MM - length / 2) * scale, height - 10 * scale);
        pen.scale(scale, -scale);
        pen.setColor(colors().grey(0.35));
        pen.setStroke(DrawingColors.stroke(2.5));
        pen.draw(new Line2D.Double(-FigureDrawing.REAR_MM, 0, FigureDrawing.AHEAD_MM, 0));
        new FigureDrawing(dog, Projection.SIDE, colors(), isEnabled()).paint(pen);
        pen.dispose();
    }

    private void paintAbove(Graphics2D pen) {
        double width = pen.getClipBounds().getWidth();
        double height = pen.getClipBounds().getHeight();
        double size = Math.min(width, height);
        double scale = HEAD_AT * size / BEHIND_HEAD_MM;
        pen.translate(width / 2, (height + size) / 2 - HEAD_AT * size);
        new BeamsDrawing(dog, colors(), REACH * size, scale * NOSE_MM).paint(pen);
        pen.scale(scale, -scale);
        FigureDrawing figure = new FigureDrawing(dog, Projection.ABOVE, colors(), isEnabled());
        pen.translate(0, -figure.skeleton().neckFoot().x());
        figure.paint(pen);
        pen.dispose();
    }

    private void paintFace(Graphics2D pen) {
        double width = pen.getClipBounds().getWidth();
        double height = pen.getClipBounds().getHeight();
        double tall = FaceDrawing.TOP_MM + FaceDrawing.FOOT_MM;
        double scale = 0.9 * Math.min(width / (2 * FaceDrawing.HALF_WIDTH_MM), height / tall);
        pen.translate(width / 2, (height - scale * tall) / 2 + scale * FaceDrawing.TOP_MM);
        pen.scale(scale, -scale);
        new FaceDrawing(dog, colors(), isEnabled()).paint(pen);
        pen.dispose();
    }
}
