package majic.nav.range;

import majic.bot.Pose;

/** The pose of one frame seen from another. */
public final class RelativePose {
    private RelativePose() {}

    /**
     * Returns where a pose is, seen from another one.
     *
     * @param from the pose that is the origin of the new frame
     * @param to in the same frame as {@code from}
     * @return the pose for which {@code from.plus(result)} is {@code to}
     */
    public static Pose of(Pose from, Pose to) {
        return Pose.START.originOf(from).plus(to);
    }
}
