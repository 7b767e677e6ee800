package majic.aibo.panel;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JPanel;
import majic.aibo.body.DogState;
import majic.aibo.body.LedNames;
import majic.aibo.body.Sensor;
import majic.aibo.body.Skeleton;
import majic.panel.DrawingColors;
import majic.text.Texts;

/**
 * Draws the dog three times with its joints as they were measured: from its right, from above with what its distance
 * sensors meet, and its face. As large as the room allows; faded while disabled. For the event thread.
 */
final class DogDrawing extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(DogDrawing.class);

    /** Wider than this for its height, and all three stand in a row. */
    private static final double WIDE = 2.1;

    /** Higher than this for its width, and all three stand below each other. */
    private static final double NARROW = 1.3;

    /** Of the room from above: how far from its foot the head turns, and how far the beams reach beyond. */
    private static final double HEAD_AT = 0.55;

    private static final double REACH = 0.43;
    private static final double NOSE_MM = 104;
    private static final double BEHIND_HEAD_MM = 270;

    /** The distances alone do not change the figure, the accelerations only its pitch, and the others are not drawn. */
    private static final Set<Sensor> FIGURE = EnumSet.complementOf(EnumSet.of(
            Sensor.NEAR,
            Sensor.FAR,
            Sensor.CHEST,
            Sensor.ACCEL_X,
            Sensor.ACCEL_Y,
            Sensor.ACCEL_Z,
            Sensor.LEG_LOAD,
            Sensor.CHARGE,
            Sensor.POSTURE));

    private static final List<String> FACE_LEDS =
            LedNames.all().stream().filter(FaceDrawing::isOnlyThere).toList();
    private static final List<String> BACK_LEDS =
            LedNames.all().stream().filter(led -> led.startsWith("ledB")).toList();
    private static final List<String> OTHER_LEDS_AND_EARS = Stream.concat(
                    LedNames.all().stream().filter(led -> !FACE_LEDS.contains(led) && !BACK_LEDS.contains(led)),
                    Stream.of("earL", "earR"))
            .toList();

    /** A change that is too small to be seen: degrees, tenths of an LED, mm of a distance. */
    private static final double UNSEEN = 0.3;

    private final transient DogState dog;
    private final transient Painted figure = new Painted();
    private final transient Painted beams = new Painted();
    private final transient Painted faceLeds = new Painted();
    private final transient Painted backLeds = new Painted();

    DogDrawing(DogState dog) {
        this.dog = dog;
        setOpaque(false);
        getAccessibleContext().setAccessibleName(TEXTS.get("drawing"));
        setToolTipText(TEXTS.get("drawing.tip"));
    }

    /** The areas of the three views. */
    private record Views(Rectangle side, Rectangle above, Rectangle face) {}

    /** Paints the views anew that have changed since the last call. */
    void refresh() {
        boolean all = figure.change(figure());
        boolean above = beams.change(beams());
        boolean faceOnly = faceLeds.change(leds(FACE_LEDS));
        boolean backOnly = backLeds.change(leds(BACK_LEDS));
        if (all) {
            repaint();
            return;
        }
        if (above) {
            repaint(views().above());
        }
        if (faceOnly) {
            repaint(views().face());
        }
        if (backOnly) {
            repaintBack(Projection.SIDE, views().side(), sideFrame(views().side()));
            repaintBack(Projection.ABOVE, views().above(), aboveFrame(views().above()));
        }
    }

    /** Paints the LEDs of the back anew, which shine in turn while nothing else changes. */
    private void repaintBack(Projection from, Rectangle view, AffineTransform frame) {
        Rectangle2D leds = new FigureDrawing(dog, from, colors(), isEnabled()).backLeds();
        Rectangle area = frame.createTransformedShape(leds).getBounds();
        area.translate(view.x, view.y);
        area.grow(1, 1);
        repaint(area);
    }

    /** Returns what all views depend on. */
    private DoubleStream figure() {
        DoubleStream whole = DoubleStream.of(isEnabled() ? 1 : 0, new Skeleton(dog.senses()).pitchDeg());
        DoubleStream senses = FIGURE.stream()
                .mapToDouble(sensor -> dog.senses().number(sensor).orElse(Double.NaN));
        return DoubleStream.concat(whole, DoubleStream.concat(senses, leds(OTHER_LEDS_AND_EARS)));
    }

    /** Returns what the view from above has in addition to the figure. */
    private DoubleStream beams() {
        return Stream.of(dog.infraRed().headMm(), dog.infraRed().chestMm(), dog.frontMm())
                .mapToDouble(mm -> mm.orElse(Double.NaN));
    }

    /** Returns the amounts of some LEDs, in tenths. */
    private DoubleStream leds(List<String> names) {
        return names.stream().mapToDouble(led -> 10 * dog.leds().amount(led).orElse(Double.NaN));
    }

    /** What was painted last, with which the present is compared, so that small changes add up until they are seen. */
    private static final class Painted {
        private double[] values = {};

        /** Returns whether something looks different now; it counts as painted then. */
        boolean change(DoubleStream present) {
            double[] now = present.toArray();
            boolean different = looksDifferent(now);
            if (different) {
                values = now;
            }
            return different;
        }

        private boolean looksDifferent(double[] now) {
            return now.length != values.length
                    || IntStream.range(0, now.length)
                            .anyMatch(index -> Double.isNaN(now[index]) != Double.isNaN(values[index])
                                    || Math.abs(now[index] - values[index]) > UNSEEN);
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        Views views = views();
        paint(pen, views.side(), this::paintSide);
        paint(pen, views.above(), this::paintAbove);
        paint(pen, views.face(), this::paintFace);
        pen.dispose();
    }

    private static void paint(Graphics2D pen, Rectangle view, BiConsumer<Graphics2D, Dimension> painter) {
        if (pen.hitClip(view.x, view.y, view.width, view.height)) {
            Graphics2D part = (Graphics2D) pen.create(view.x, view.y, view.width, view.height);
            painter.accept(part, view.getSize());
            part.dispose();
        }
    }

    private Views views() {
        int width = getWidth();
        int height = getHeight();
        if (width > WIDE * height) {
            int each = (int) (0.36 * width);
            return new Views(
                    new Rectangle(0, 0, each, height),
                    new Rectangle(each, 0, each, height),
                    new Rectangle(2 * each, 0, width - 2 * each, height));
        }
        if (height > NARROW * width) {
            int side = (int) (0.35 * height);
            int face = (int) (0.26 * height);
            return new Views(
                    new Rectangle(0, 0, width, side),
                    new Rectangle(0, side, width, height - side - face),
                    new Rectangle(0, height - face, width, face));
        }
        int side = (int) (0.46 * height);
        int above = (int) (0.6 * width);
        return new Views(
                new Rectangle(0, 0, width, side),
                new Rectangle(0, side, above, height - side),
                new Rectangle(above, side, width - above, height - side));
    }

    private DrawingColors colors() {
        return isEnabled() ? DrawingColors.current() : DrawingColors.current().faded();
    }

    private void paintSide(Graphics2D pen, Dimension room) {
        pen.transform(sideFrame(new Rectangle(room)));
        pen.setColor(colors().grey(0.35));
        pen.setStroke(DrawingColors.stroke(2.5));
        pen.draw(new Line2D.Double(-FigureDrawing.REAR_MM, 0, FigureDrawing.AHEAD_MM, 0));
        new FigureDrawing(dog, Projection.SIDE, colors(), isEnabled()).paint(pen);
    }

    /** The frame of the view from its right, in mm. */
    private static AffineTransform sideFrame(Rectangle room) {
        double length = FigureDrawing.AHEAD_MM + FigureDrawing.REAR_MM;
        double scale = Math.min(room.width / length, room.height / (FigureDrawing.HIGH_MM + 16));
        AffineTransform frame = AffineTransform.getTranslateInstance(
                room.width / 2.0 + (FigureDrawing.REAR_MM - length / 2) * scale, room.height - 10 * scale);
        frame.scale(scale, -scale);
        return frame;
    }

    /** The frame of the view from above, in mm. */
    private AffineTransform aboveFrame(Rectangle room) {
        double size = Math.min(room.width, room.height);
        double scale = HEAD_AT * size / BEHIND_HEAD_MM;
        AffineTransform frame =
                AffineTransform.getTranslateInstance(room.width / 2.0, (room.height + size) / 2 - HEAD_AT * size);
        frame.scale(scale, -scale);
        frame.translate(0, -new Skeleton(dog.senses()).neckFoot().x());
        return frame;
    }

    private void paintAbove(Graphics2D pen, Dimension room) {
        double width = room.getWidth();
        double height = room.getHeight();
        double size = Math.min(width, height);
        double scale = HEAD_AT * size / BEHIND_HEAD_MM;
        Graphics2D figure = (Graphics2D) pen.create();
        figure.transform(aboveFrame(new Rectangle(room)));
        pen.translate(width / 2, (height + size) / 2 - HEAD_AT * size);
        BeamsDrawing beams = new BeamsDrawing(dog, colors(), REACH * size, scale * NOSE_MM);
        beams.paint(pen);
        new FigureDrawing(dog, Projection.ABOVE, colors(), isEnabled()).paint(figure);
        figure.dispose();
        beams.paintLabel(pen, width / 2);
    }

    private void paintFace(Graphics2D pen, Dimension room) {
        double width = room.getWidth();
        double height = room.getHeight();
        double tall = FaceDrawing.TOP_MM + FaceDrawing.FOOT_MM;
        double scale = 0.9 * Math.min(width / (2 * FaceDrawing.HALF_WIDTH_MM), height / tall);
        pen.translate(width / 2, (height - scale * tall) / 2 + scale * FaceDrawing.TOP_MM);
        pen.scale(scale, -scale);
        new FaceDrawing(dog, colors(), isEnabled()).paint(pen);
    }
}
