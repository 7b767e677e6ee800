package majic.nav.mapping;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;

/** A floor of walls, for scans with known truth: mm; noise of a fixed seed. */
public final class Floor {
    /** A scanner of 180 degrees in steps of 1 degree. */
    public static final RangeSensor LASER = RangeSensor.laser(Pose.START, 181, -90, 1, 20_000, 10);

    private final List<double[]> walls = new ArrayList<>();
    private final Random random;

    private Floor(long seed) {
        random = new Random(seed);
    }

    /**
     * A corridor of 2 m around a block of 20 m by 14 m, with niches and pillars in places that do not repeat; its
     * middle line begins at (0, 0) and runs counterclockwise through (22000, 0), (22000, 16000) and (0, 16000).
     */
    public static Floor ring(long seed) {
        Floor floor = new Floor(seed);
        floor.box(-1000, -1000, 23_000, 17_000);
        floor.box(1000, 1000, 21_000, 15_000);
        Random places = new Random(7);
        for (int index = 0; index < 24; index++) {
            double along = 1500 + places.nextInt(19_000);
            double size = 150 + places.nextInt(350);
            double side = index % 4;
            if (side == 0) {
                floor.box(along, -1000, along + size, -1000 + size / 2);
            } else if (side == 1) {
                floor.box(23_000 - size / 2, along * 0.7, 23_000, along * 0.7 + size);
            } else if (side == 2) {
                floor.box(along, 17_000 - size / 2, along + size, 17_000);
            } else {
                floor.box(-1000, along * 0.7, -1000 + size / 2, along * 0.7 + size);
            }
        }
        return floor;
    }

    private void box(double x1, double y1, double x2, double y2) {
        walls.add(new double[] {x1, y1, x2, y1});
        walls.add(new double[] {x2, y1, x2, y2});
        walls.add(new double[] {x2, y2, x1, y2});
        walls.add(new double[] {x1, y2, x1, y1});
    }

    /** The way around the ring in steps of 200 mm and 9 degrees, some rounds. */
    public static List<Pose> around(int rounds) {
        List<Pose> way = new ArrayList<>();
        way.add(Pose.START);
        double[] sides = {22_000, 16_000, 22_000, 16_000};
        for (int side = 0; side < 4 * rounds; side++) {
            for (int step = 0; step < sides[side % 4] / 200; step++) {
                way.add(way.get(way.size() - 1).after(200, 0));
            }
            for (int step = 0; step < 10; step++) {
                way.add(way.get(way.size() - 1).after(0, 9));
            }
        }
        return way;
    }

    /**
     * The odometry of a way: each step is too long and turned too far by the shares, with noise.
     *
     * @param share of a step's length
     * @param degPerM a turn that the odometry reports although there was none
     */
    public List<Pose> odometry(List<Pose> way, double share, double degPerM) {
        List<Pose> odometry = new ArrayList<>(List.of(way.get(0)));
        for (int index = 1; index < way.size(); index++) {
            Pose step = way.get(index).seenFrom(way.get(index - 1));
            double length = Math.hypot(step.xMm(), step.yMm());
            odometry.add(odometry.get(index - 1)
                    .plus(new Pose(
                            step.xMm() * (1 + share + 0.02 * random.nextGaussian()),
                            step.yMm(),
                            step.headingDeg() * (1 + 0.02 * random.nextGaussian()) + degPerM * length / 1000)));
        }
        return odometry;
    }

    /** A scan with noise at a true place, beside its odometry. */
    public RangeScan scan(RangeSensor sensor, double timeS, Pose truth, Pose odometry) {
        float[] ranges = new float[sensor.beams().size()];
        for (int index = 0; index < ranges.length; index++) {
            Beam beam = sensor.beams().get(index);
            Pose from = truth.plus(beam.mount());
            double range = range(from);
            ranges[index] = (float) (range + beam.noiseMm() * random.nextGaussian());
        }
        return new RangeScan(sensor, timeS, odometry, ranges);
    }

    private double range(Pose from) {
        double angle = Math.toRadians(from.headingDeg());
        double dx = Math.cos(angle);
        double dy = Math.sin(angle);
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] wall : walls) {
            double wx = wall[2] - wall[0];
            double wy = wall[3] - wall[1];
            double cross = dx * wy - dy * wx;
            double ox = wall[0] - from.xMm();
            double oy = wall[1] - from.yMm();
            double distance = (ox * wy - oy * wx) / cross;
            double share = (ox * dy - oy * dx) / cross;
            if (distance > 0 && share >= 0 && share <= 1) {
                nearest = Math.min(nearest, distance);
            }
        }
        return nearest;
    }
}
