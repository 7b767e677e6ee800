package majic.gui.map;

import majic.bot.Pose;

/** Converts poses from one frame of reference to another. */
final class PoseFrames {
    private PoseFrames() {}

    /** Converts a pose relative to an origin into the frame of that origin. */
    static Pose at(Pose origin, Pose relative) {
        double angle = Math.toRadians(origin.headingDeg());
        double x = origin.xMm() + relative.xMm() * Math.cos(angle) - relative.yMm() * Math.sin(angle);
        double y = origin.yMm() + relative.xMm() * Math.sin(angle) + relative.yMm() * Math.cos(angle);
        return new Pose(x, y, origin.headingDeg() + relative.headingDeg());
    }

    /** Returns the origin for which {@code at(origin, relative)} is the given place. */
    static Pose originOf(Pose place, Pose relative) {
        Pose turned = new Pose(0, 0, place.headingDeg() - relative.headingDeg());
        Pose offset = at(turned, relative);
        return new Pose(place.xMm() - offset.xMm(), place.yMm() - offset.yMm(), turned.headingDeg());
    }
}
