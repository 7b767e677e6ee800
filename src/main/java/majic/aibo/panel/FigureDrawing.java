package majic.aibo.panel;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import majic.aibo.body.BodyPoint;
import majic.aibo.body.DogState;
import majic.aibo.body.Limb;
import majic.aibo.body.Sensor;
import majic.aibo.body.Skeleton;
import majic.panel.DrawingColors;

/** The whole dog as one view shows it, with every joint as it was measured; in mm, the ground at 0. */
final class FigureDrawing {
    /** How far it reaches ahead and to the rear of its middle, and up, in most of its postures. */
    static final double AHEAD_MM = 190;

    static final double REAR_MM = 185;
    static final double HIGH_MM = 305;

    private static final List<String> PLACES = List.of("F", "M", "R");
    private static final List<Color> COLOURS = List.of(LedDrawing.BLUE, LedDrawing.ORANGE, LedDrawing.RED);
    private static final List<Sensor> PADS = List.of(Sensor.BACK_FRONT, Sensor.BACK_MIDDLE, Sensor.BACK_REAR);
    private static final double FIRST_PAD_MM = 38;
    private static final double PAD_STEP_MM = 40;
    private static final int TAIL_PIECES = 6;

    /** A paw is seen whole: no leg hides the one it stands on. */
    private static final double BEHIND_PAW_MM = 20;

    private final DogState dog;
    private final Skeleton skeleton;
    private final Projection view;
    private final DrawingColors colors;
    private final boolean live;

    /** A live dog's LEDs shine. */
    FigureDrawing(DogState dog, Projection view, DrawingColors colors, boolean live) {
        this.dog = dog;
        this.skeleton = new Skeleton(dog.senses());
        this.view = view;
        this.colors = colors;
        this.live = live;
    }

    void paint(Graphics2D pen) {
        PartsDrawing parts = new PartsDrawing(view, colors, live);
        for (Limb limb : Limb.values()) {
            addLeg(parts, limb);
        }
        addTail(parts);
        parts.bone(skeleton.body(new BodyPoint(-46, 0, 0)), skeleton.body(new BodyPoint(42, 0, 2)), 102, 0.12);
        for (int place = 0; place < PLACES.size(); place++) {
            addBack(parts, place);
        }
        new HeadDrawing(dog, skeleton, colors).addTo(parts);
        parts.paint(pen);
    }

    /** The paw shows the accent while it feels the ground. */
    private void addLeg(PartsDrawing parts, Limb limb) {
        Limb.Bones bones = skeleton.leg(limb);
        parts.boneBehind(BEHIND_PAW_MM, bones.top(), bones.middle(), 46, 0.26);
        parts.boneBehind(BEHIND_PAW_MM, bones.middle(), bones.foot(), 32, 0.2);
        boolean down = dog.senses().isPressed(limb.paw());
        BodyPoint toe = bones.foot().plus(new BodyPoint(12, 0, -1));
        parts.part(bones.foot().plus(new BodyPoint(-3, 0, -1)), toe, 27, down ? colors.accent() : colors.paper());
    }

    private void addTail(PartsDrawing parts) {
        for (int piece = 0; piece < TAIL_PIECES; piece++) {
            BodyPoint from = skeleton.tail((double) piece / TAIL_PIECES);
            parts.bone(from, skeleton.tail((piece + 1.0) / TAIL_PIECES), 17, 0.5);
        }
    }

    /** A pad to stroke, and beneath it a coloured and a white LED. */
    private void addBack(PartsDrawing parts, int place) {
        double x = FIRST_PAD_MM - place * PAD_STEP_MM;
        boolean pressed = dog.senses().isPressed(PADS.get(place));
        parts.pad(skeleton.body(new BodyPoint(x - 9, 0, 51)), skeleton.body(new BodyPoint(x + 9, 0, 51)), 15, pressed);
        String name = "ledB" + PLACES.get(place);
        parts.led(colouredLed(x), COLOURS.get(place), dog.leds().amount(name + "C"));
        parts.led(whiteLed(x), LedDrawing.WHITE, dog.leds().amount(name + "W"));
    }

    private BodyPoint colouredLed(double x) {
        return skeleton.body(new BodyPoint(x - 8, -24, ledHeight()));
    }

    private BodyPoint whiteLed(double x) {
        double left = view == Projection.SIDE ? -24 : 24;
        double further = view == Projection.SIDE ? 8 : -8;
        return skeleton.body(new BodyPoint(x + further, left, ledHeight()));
    }

    private double ledHeight() {
        return view == Projection.SIDE ? 31 : 48;
    }

    /** The area in which the LEDs of the back shine, in mm of the view. */
    Rectangle2D backLeds() {
        Rectangle2D area = around(colouredLed(FIRST_PAD_MM));
        for (int place = 0; place < PLACES.size(); place++) {
            double x = FIRST_PAD_MM - place * PAD_STEP_MM;
            area.add(around(colouredLed(x)));
            area.add(around(whiteLed(x)));
        }
        return area;
    }

    private Rectangle2D around(BodyPoint led) {
        double reach = PartsDrawing.LED_REACH_MM;
        return new Rectangle2D.Double(view.across(led) - reach, view.up(led) - reach, 2 * reach, 2 * reach);
    }
}
