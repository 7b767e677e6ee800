package majic.gui.kit;

import majic.bot.Pose;

/** Converts poses from one frame of reference to another. */
public final class Frames {
    private Frames() {}

    /** Converts a pose relative to an origin into the frame of that origin. */
    public static Pose at(Pose origin, Pose told) {
        double angle = Math.toRadians(origin.headingDeg());
        double x = origin.xMm() + told.xMm() * Math.cos(angle) - told.yMm() * Math.sin(angle);
        double y = origin.yMm() + told.xMm() * Math.sin(angle) + told.yMm() * Math.cos(angle);
        return new Pose(x, y, origin.headingDeg() + told.headingDeg());
    }

    /** Returns the origin for which {@code at(origin, told)} is the given place. */
    public static Pose originOf(Pose place, Pose told) {
        Pose turned = new Pose(0, 0, place.headingDeg() - told.headingDeg());
        Pose offset = at(turned, told);
        return new Pose(place.xMm() - offset.xMm(), place.yMm() - offset.yMm(), turned.headingDeg());
    }
}
