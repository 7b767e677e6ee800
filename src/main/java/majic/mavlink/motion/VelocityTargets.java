package majic.mavlink.motion;

import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.session.VehicleClass;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.velocity.VelocityOutput;

/**
 * Sends the velocities of motions as targets, which the autopilot follows for 3 s. Used by one thread at a time, under
 * the lock of what makes the velocities.
 */
final class VelocityTargets implements VelocityOutput {
    /** Between two targets of a velocity that stays, seconds: ten a second. */
    private static final double TARGET_S = 0.09;

    private final VehicleSession session;
    private final GuidedMode mode;
    private final TimeSource time;
    private volatile boolean moved;
    private volatile long sentNanos;

    VelocityTargets(VehicleSession session, GuidedMode mode, TimeSource time) {
        this.session = session;
        this.mode = mode;
        this.time = time;
    }

    @Override
    public void publish(double mmPerSec, double degPerSec) {
        publish(mmPerSec, degPerSec, 0);
    }

    /** Sends a velocity of a copter; up positive, mm/s. */
    void climb(double mmPerSec) {
        publish(0, 0, mmPerSec);
    }

    /** Ten targets a second suffice, and a radio carries no more; a change to zero is sent at once. */
    private void publish(double mmPerSec, double degPerSec, double climb) {
        boolean moves = mmPerSec != 0 || degPerSec != 0 || climb != 0;
        if (moves == moved && sentNanos != 0 && time.secondsSince(sentNanos) < TARGET_S) {
            return;
        }
        if (moves && !mode.isHeld()) {
            return;
        }
        if (moves) {
            session.refuseAfterSuspend();
        }
        moved = moves;
        sentNanos = time.nanos();
        session.send(
                session.vehicle() == VehicleClass.COPTER
                        ? MavlinkRequests.flight(session.system(), mmPerSec, degPerSec, climb)
                        : MavlinkRequests.velocity(session.system(), mmPerSec, degPerSec));
    }
}
