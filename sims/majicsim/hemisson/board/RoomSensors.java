package majicsim.hemisson.board;

import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * The infra-red sensors in a room: six around the robot with a beam of about 30° each, and two that face the ground.
 */
public final class RoomSensors implements InfraRedSensors {
    private static final double[] LOOKS_TO_DEG = {0, -38, 38, -90, 90, 180};

    /** Sheet 6; the rear one drawn in to the rim of the disc that stands for the body. */
    private static final double[][] PLACES_MM = {
        {57.5, 0}, {51, -31}, {51, 31}, {10, -49}, {10, 49}, {-59.5, 0}, {57, -5}, {57, 5}
    };

    /** The beam is some 30° wide, and weaker to its sides. */
    private static final double[] BEAM_DEG = {-14, -7, 0, 7, 14};

    private static final double[] BEAM_WEIGHT = {0.5, 0.8, 1, 0.8, 0.5};

    private static final double[] CURVE_MM = {0, 10, 20, 30, 40, 50, 60, 80, 100};
    private static final double[] CURVE_VALUE = {250, 150, 48, 20, 13, 8, 5, 4, 2};
    private static final double FARTHEST_MM = 100;
    private static final double MOST_STRAY = 4;
    private static final double BELOW_ZERO = 0.02;

    /** White floor a few millimetres below the ground sensors. */
    private static final double WHITE_FLOOR = 165;

    /** How far the brightest lamp lowers the ambient reading. */
    private static final double LAMP_FALL = 233;

    private static final double RESPONSE_NOISE = 0.045;
    private static final double READING_NOISE = 0.8;

    private final World world;
    private final Body body;
    private final Noise noise;
    private int ambientReading;

    public RoomSensors(World world, Body body, Noise noise, int ambientReading) {
        this.world = world;
        this.body = body;
        this.noise = noise;
        this.ambientReading = ambientReading;
    }

    @Override
    public void look(int[] ambient, int[] response) {
        for (int i = 0; i < COUNT; i++) {
            Point place = body.pose().toWorld(PLACES_MM[i][0], PLACES_MM[i][1]);
            boolean looksAround = i < LOOKS_TO_DEG.length;
            double lamps = looksAround ? lamps(place, LOOKS_TO_DEG[i]) : world.scatteredLight(place);
            ambient[i] = byteOf(ambientReading - LAMP_FALL * lamps + reading());
            double ideal = looksAround ? beam(place, LOOKS_TO_DEG[i]) : floor(place);
            response[i] = (int) Math.round(Math.max(stray(), ideal * noise.scale(RESPONSE_NOISE)));
        }
    }

    /** Sets the light of the room. */
    public void ambient(int reading) {
        ambientReading = reading;
    }

    private double lamps(Point place, double directionDeg) {
        return world.lampLight(new Pose(place.xMm(), place.yMm(), body.pose().toWorldDeg(directionDeg)));
    }

    private double floor(Point place) {
        return WHITE_FLOOR * world.floorReflectivity(place.xMm(), place.yMm());
    }

    /** The reading with nothing in range: small, and sometimes negative. */
    private double stray() {
        return noise.chance(BELOW_ZERO) ? -1 : noise.uniform(0, MOST_STRAY);
    }

    /** The strongest echo of a few rays. */
    private double beam(Point from, double directionDeg) {
        double strongest = Double.NEGATIVE_INFINITY;
        View view = world.view(body, from, FARTHEST_MM);
        for (int i = 0; i < BEAM_DEG.length; i++) {
            double direction = body.pose().toWorldDeg(directionDeg + BEAM_DEG[i]);
            Hit hit = view.ray(direction, FARTHEST_MM);
            if (hit.found()) {
                strongest = Math.max(strongest, curve(hit.distanceMm()) * hit.reflectivity() * BEAM_WEIGHT[i]);
            }
        }
        return strongest;
    }

    public static double curve(double distanceMm) {
        for (int i = 1; i < CURVE_MM.length; i++) {
            if (distanceMm <= CURVE_MM[i]) {
                double part = (distanceMm - CURVE_MM[i - 1]) / (CURVE_MM[i] - CURVE_MM[i - 1]);
                return CURVE_VALUE[i - 1] + part * (CURVE_VALUE[i] - CURVE_VALUE[i - 1]);
            }
        }
        return CURVE_VALUE[CURVE_VALUE.length - 1];
    }

    private double reading() {
        return noise.gaussian(READING_NOISE);
    }

    private static int byteOf(double value) {
        return (int) Math.max(0, Math.min(255, Math.round(value)));
    }
}
