package majic.nav.mapping;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.Pose;

/**
 * The way of the robot on the map at the rate of its odometry: between two scans the odometry, corrected by a share of
 * what it was wrong by at the later one that grows with the way and the turn. Not thread-safe.
 */
public final class Trajectory {
    /**
     * The pose of the robot's centre at a time.
     *
     * @param timeS of the odometry, s
     * @param pose on the map
     */
    public record TimedPose(double timeS, Pose pose) {}

    private record Odometry(double timeS, Pose pose, int scan, double alongMm) {}

    /** By which turns count as way: half a metre for a quarter turn, as wheels travel at a distance of 0.3 m. */
    private static final double MM_PER_DEG = 5;

    private final Mapper mapper;
    private final List<Odometry> odometry = new ArrayList<>();
    private double alongMm;

    /**
     * Makes an empty one.
     *
     * @param mapper the mapper of the scans
     */
    public Trajectory(Mapper mapper) {
        this.mapper = mapper;
    }

    /**
     * Adds the odometry of a moment, after a scan of the same moment has been added to the mapper.
     *
     * @param timeS s
     * @param pose in the frame of the odometry
     */
    public void add(double timeS, Pose pose) {
        if (!odometry.isEmpty()) {
            Pose last = odometry.get(odometry.size() - 1).pose();
            alongMm += last.distanceMm(pose)
                    + MM_PER_DEG * Math.abs(Pose.normalised(pose.headingDeg() - last.headingDeg()));
        }
        odometry.add(new Odometry(timeS, pose, mapper.scans() - 1, alongMm));
    }

    /** Returns the poses on the map, as far as they are known now, in the order in which they were added. */
    public List<TimedPose> poses() {
        List<TimedPose> poses = new ArrayList<>();
        for (int first = 0; first < odometry.size(); ) {
            int scan = odometry.get(first).scan();
            int next = first;
            while (next < odometry.size() && odometry.get(next).scan() == scan) {
                next++;
            }
            place(first, next, poses);
            first = next;
        }
        return poses;
    }

    /** Places the odometry between two scans, of which the later one has the index {@code to}. */
    private void place(int from, int to, List<TimedPose> poses) {
        int scan = odometry.get(from).scan();
        OptionalInt later = to < odometry.size() && scan >= 0 ? OptionalInt.of(scan + 1) : OptionalInt.empty();
        Pose error = later.isEmpty() ? Pose.START : error(scan, later.getAsInt());
        double begin = odometry.get(from).alongMm();
        double length = to < odometry.size() ? odometry.get(to).alongMm() - begin : 0;
        for (Odometry at : odometry.subList(from, to)) {
            double share = length > 0 ? (at.alongMm() - begin) / length : 0;
            Pose pose = predicted(Math.max(scan, 0), at.pose());
            poses.add(new TimedPose(
                    at.timeS(),
                    new Pose(
                            pose.xMm() + share * error.xMm(),
                            pose.yMm() + share * error.yMm(),
                            pose.headingDeg() + share * error.headingDeg())));
        }
    }

    private Pose predicted(int scan, Pose pose) {
        return mapper.scans() == 0
                ? pose
                : mapper.pose(scan).plus(pose.seenFrom(mapper.scan(scan).odometry()));
    }

    /**
     * The difference of a scan's place from what the odometry gives since the scan before, along the axes of the map.
     */
    private Pose error(int scan, int later) {
        Pose is = mapper.pose(later);
        Pose predicted = predicted(scan, mapper.scan(later).odometry());
        return new Pose(
                is.xMm() - predicted.xMm(), is.yMm() - predicted.yMm(), is.headingDeg() - predicted.headingDeg());
    }
}
