package majic.inlab.acts;

import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/** Counts how often a robot moves round a point, in either direction. */
final class Rounds {
    private final Pose middle;
    private @Nullable Double lastDeg;
    private double turnedDeg;

    Rounds(Pose middle) {
        this.middle = middle;
    }

    void add(Pose at) {
        double deg = Math.toDegrees(Math.atan2(at.yMm() - middle.yMm(), at.xMm() - middle.xMm()));
        if (lastDeg != null) {
            turnedDeg += Math.IEEEremainder(deg - lastDeg, 360);
        }
        lastDeg = deg;
    }

    double done() {
        return Math.abs(turnedDeg) / 360;
    }
}
