package majicsim.pioneer;

import majicsim.world.Contact;

/**
 * The bumper segments of a model: rows of equal segments, the front one from left to right, the rear one from right to
 * left as the count goes on clockwise. Each row spans 160 degrees seen from the turning centre.
 */
final class Bumpers {
    private static final double SPAN_DEG = 160;

    private Bumpers() {}

    /** The front row's bits 1 to 7 as the SIP has them. */
    static int front(PioneerModel model, Contact contact) {
        return bits(model.frontBumpers(), contact, contact.directionDeg());
    }

    /** The rear row's bits 1 to 7 as the SIP has them. */
    static int rear(PioneerModel model, Contact contact) {
        double fromRear = contact.directionDeg() > 0 ? contact.directionDeg() - 180 : contact.directionDeg() + 180;
        return bits(model.rearBumpers(), contact, fromRear);
    }

    private static int bits(int segments, Contact contact, double fromMiddleDeg) {
        if (!contact.touching() || segments == 0 || Math.abs(fromMiddleDeg) > SPAN_DEG / 2) {
            return 0;
        }
        int segment = (int) ((SPAN_DEG / 2 - fromMiddleDeg) / SPAN_DEG * segments);
        return 1 << 1 + Math.min(segments - 1, segment);
    }
}
