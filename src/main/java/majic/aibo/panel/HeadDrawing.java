package majic.aibo.panel;

import java.awt.Color;
import majic.aibo.body.BodyPoint;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.body.Skeleton;
import majic.panel.DrawingColors;

/** The head with its visor, jaw and ears, its touch sensors and LEDs. */
final class HeadDrawing {
    private static final BodyPoint SKULL = new BodyPoint(-4, 0, 16);
    private static final BodyPoint JAW_HINGE = new BodyPoint(18, 0, -20);
    private static final BodyPoint JAW = new BodyPoint(40, 0, 0);
    private static final double EAR_MM = 42;

    /** The head sits on the neck and hides its upper end, however it is turned. */
    private static final double NECK_BEHIND_MM = 60;

    private final DogState dog;
    private final Skeleton skeleton;
    private final DrawingColors colors;

    HeadDrawing(DogState dog, Skeleton skeleton, DrawingColors colors) {
        this.dog = dog;
        this.skeleton = skeleton;
        this.colors = colors;
    }

    /** The look of the visor, behind which the LEDs of the face are. */
    static Color visor(DrawingColors colors) {
        return new Color(0x23292F).equals(colors.paper()) ? colors.grey(0.3) : new Color(0x23292F);
    }

    void addTo(PartsDrawing parts) {
        parts.boneBehind(NECK_BEHIND_MM, skeleton.neckFoot(), skeleton.head(new BodyPoint(0, 0, -14)), 40, 0.4);
        parts.bone(skeleton.head(SKULL), skeleton.head(new BodyPoint(6, 0, 16)), 82, 0.08);
        parts.bone(skeleton.head(new BodyPoint(24, 0, 8)), skeleton.head(new BodyPoint(46, 0, 4)), 56, 0.08);
        parts.part(skeleton.head(new BodyPoint(58, 0, 8)), skeleton.head(new BodyPoint(62, 0, 2)), 36, visor(colors));
        parts.bone(skeleton.head(JAW_HINGE), skeleton.jaw(JAW_HINGE, JAW), 19, 0.3);
        addTouch(parts);
        addEar(parts, 1, "earL");
        addEar(parts, -1, "earR");
        parts.led(
                skeleton.head(new BodyPoint(18, -9, 52)),
                LedDrawing.ORANGE,
                dog.leds().amount("ledHC"));
        parts.led(
                skeleton.head(new BodyPoint(18, 9, 52)),
                LedDrawing.WHITE,
                dog.leds().amount("ledHW"));
        parts.led(
                skeleton.head(new BodyPoint(-42, 0, 26)),
                LedDrawing.BLUE,
                dog.leds().amount("ledWIFI"));
    }

    private void addTouch(PartsDrawing parts) {
        BodyPoint chin = skeleton.jaw(JAW_HINGE, new BodyPoint(34, 0, -9));
        parts.pad(
                chin,
                skeleton.jaw(JAW_HINGE, new BodyPoint(42, 0, -9)),
                13,
                dog.senses().isPressed(Sensor.CHIN));
        BodyPoint top = skeleton.head(new BodyPoint(-14, 0, 56));
        parts.pad(top, skeleton.head(new BodyPoint(2, 0, 57)), 15, dog.senses().isPressed(Sensor.HEAD_TOUCH));
    }

    /** Hangs down, or stands off when it is flicked. */
    private void addEar(PartsDrawing parts, int side, String device) {
        boolean flicked = dog.leds().amount(device).orElse(0.0) > 0.5;
        BodyPoint root = new BodyPoint(-16, side * 38, 34);
        BodyPoint hang = new BodyPoint(-4, 0, -EAR_MM).spread(side * (flicked ? 75.0 : 12.0));
        parts.bone(skeleton.head(root), skeleton.head(root.plus(hang)), 24, 0.45);
    }
}
