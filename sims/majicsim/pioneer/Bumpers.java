package majicsim.pioneer;

import majicsim.world.Body;
import majicsim.world.Contact;

/**
 * The bumper segments of a robot: rows of equal segments, the front one from left to right, the rear one from right to
 * left as the count goes on clockwise. Each row spans 160 degrees seen from the turning centre.
 */
final class Bumpers {
    private static final double SPAN_DEG = 160;
    private static final int FRONT_STALLS = 1;
    private static final int REAR_STALLS = 2;

    private final PioneerModel model;
    private final Body body;

    Bumpers(PioneerModel model, Body body) {
        this.model = model;
        this.body = body;
    }

    /** The front row's segments, bit 0 for the leftmost. */
    int front() {
        return bits(model.frontBumpers(), body.contact().directionDeg());
    }

    /** The rear row's segments, bit 0 for the rightmost. */
    int rear() {
        double deg = body.contact().directionDeg();
        return bits(model.rearBumpers(), deg > 0 ? deg - 180 : deg + 180);
    }

    /** Whether a contact on the side it drives to stalls the robot, with BUMPSTALL 0 to 3 (ARCOS sheet 6.1). */
    boolean stall(int bumpStall, double mmPerSec) {
        return mmPerSec > 0 && (bumpStall & FRONT_STALLS) != 0 && front() != 0
                || mmPerSec < 0 && (bumpStall & REAR_STALLS) != 0 && rear() != 0;
    }

    private int bits(int segments, double fromMiddleDeg) {
        Contact contact = body.contact();
        if (!contact.touching() || segments == 0 || Math.abs(fromMiddleDeg) > SPAN_DEG / 2) {
            return 0;
        }
        int segment = (int) ((SPAN_DEG / 2 - fromMiddleDeg) / SPAN_DEG * segments);
        return 1 << Math.min(segments - 1, segment);
    }
}
