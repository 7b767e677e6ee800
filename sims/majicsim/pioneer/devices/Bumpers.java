package majicsim.pioneer.devices;

import majicsim.pioneer.model.PioneerModel;
import majicsim.world.Body;

/**
 * The bumper segments of a robot: rows of equal segments across its width, which reach a little round the corners. The
 * front row counts from left to right, the rear one goes on clockwise from right to left.
 */
public final class Bumpers {
    /** How far the outermost segments reach round the corners, seen from the turning centre. */
    private static final double ROUND_THE_CORNER_DEG = 20;

    private static final int FRONT_STALLS = 1;
    private static final int REAR_STALLS = 2;

    private final PioneerModel model;
    private final Body body;

    public Bumpers(PioneerModel model, Body body) {
        this.model = model;
        this.body = body;
    }

    /** The front row's segments, bit 0 for the leftmost. */
    public int front() {
        return bits(model.frontBumpers(), model.frontMm(), body.contact().directionDeg());
    }

    /** The rear row's segments, bit 0 for the rightmost. */
    public int rear() {
        double deg = body.contact().directionDeg();
        return bits(model.rearBumpers(), model.rearMm(), deg > 0 ? deg - 180 : deg + 180);
    }

    /** Whether a contact on the side of the motion stalls the robot, with BUMPSTALL 0 to 3 (ARCOS sheet 6.1). */
    public boolean stall(int bumpStall, double mmPerSec) {
        return mmPerSec > 0 && (bumpStall & FRONT_STALLS) != 0 && front() != 0
                || mmPerSec < 0 && (bumpStall & REAR_STALLS) != 0 && rear() != 0;
    }

    /**
     * The segment of a row that is touched, the row being so far from the turning centre, the touch so far off its
     * middle.
     */
    private int bits(int segments, double reachMm, double offMiddleDeg) {
        if (!body.contact().touching() || segments == 0) {
            return 0;
        }
        double cornerDeg = Math.toDegrees(Math.atan2(model.halfWidthMm(), reachMm));
        if (Math.abs(offMiddleDeg) > cornerDeg + ROUND_THE_CORNER_DEG) {
            return 0;
        }
        double alongDeg = Math.max(-cornerDeg, Math.min(cornerDeg, offMiddleDeg));
        double leftMm = reachMm * Math.tan(Math.toRadians(alongDeg));
        int segment = (int) ((model.halfWidthMm() - leftMm) / (2 * model.halfWidthMm()) * segments);
        return 1 << Math.max(0, Math.min(segments - 1, segment));
    }
}
