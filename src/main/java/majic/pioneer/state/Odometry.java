package majic.pioneer.state;

import majic.bot.Pose;
import majic.pioneer.arcos.Sip;
import org.jspecify.annotations.Nullable;

/**
 * Adds up the counters of successive SIPs to a pose relative to the first connection. Counters roll over; their
 * differences do not (ARCOS sheet 9.2). For one thread.
 */
final class Odometry {
    /** The low bits of x and y that count; the top one is unreliable. */
    private static final int COUNTER = 0x8000;

    /** More counts than any robot covers between two SIPs: the controller has reset its odometry. */
    private static final int LONGEST_STEP = 0x1000;

    private final Scaling scaling;
    private double xMm;
    private double yMm;
    private double headingDeg;
    private double rotationDeg;
    private @Nullable Sip last;

    /** Starts from a pose; the first SIP is the reference for all later ones. */
    Odometry(Scaling scaling, Pose start) {
        this.scaling = scaling;
        this.xMm = start.xMm();
        this.yMm = start.yMm();
        this.headingDeg = start.headingDeg();
    }

    void add(Sip sip) {
        Sip before = last;
        last = sip;
        if (before == null) {
            rotationDeg = headingDeg - sip.thPos() * scaling.degPerCount();
            return;
        }
        int dx = difference(sip.xPos(), before.xPos(), COUNTER);
        int dy = difference(sip.yPos(), before.yPos(), COUNTER);
        int turned = difference(sip.thPos(), before.thPos(), scaling.countsPerTurn());
        if (Math.abs(dx) > LONGEST_STEP || Math.abs(dy) > LONGEST_STEP) {
            rotationDeg = headingDeg - sip.thPos() * scaling.degPerCount();
            return;
        }
        shift(dx * scaling.mmPerCount(), dy * scaling.mmPerCount());
        headingDeg += turned * scaling.degPerCount();
    }

    /** Rotates a step from the robot's own frame into ours. */
    private void shift(double dxMm, double dyMm) {
        double cos = Math.cos(Math.toRadians(rotationDeg));
        double sin = Math.sin(Math.toRadians(rotationDeg));
        xMm += dxMm * cos - dyMm * sin;
        yMm += dxMm * sin + dyMm * cos;
    }

    Pose pose() {
        return new Pose(xMm, yMm, headingDeg);
    }

    /** All turning so far, not reduced to one turn: two turns to the left are 720. */
    double turnedDeg() {
        return headingDeg;
    }

    /** The shorter way from one reading of a counter to the next. */
    private static int difference(int now, int before, int modulus) {
        int ahead = Math.floorMod(now - before, modulus);
        return ahead < modulus / 2 ? ahead : ahead - modulus;
    }
}
