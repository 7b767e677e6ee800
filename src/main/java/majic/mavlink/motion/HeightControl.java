package majic.mavlink.motion;

import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ApproachPlan;
import majic.driver.Motion;
import majic.driver.RenewalWatch;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.velocity.Obstruction;
import majic.velocity.ObstructionSource;

/** One change of the height of a copter, controlled by the height above home that it reports. Used by one thread. */
final class HeightControl {
    private static final double PERIOD_S = 0.1;

    /** From a velocity to the report that shows it, seconds. */
    private static final double DELAY_S = 0.25;

    private static final double CRUISE_MM_PER_SEC = 500;
    private static final double CREEP_MM_PER_SEC = 100;
    private static final double ACCELERATION_MM_PER_SEC2 = 500;
    private static final double REACHED_MM = 40;
    private static final double ACCEPTABLE_MM = 100;
    private static final double TOLERABLE_MM = 300;
    private static final double RESTING_MM_PER_SEC = 60;
    private static final double SETTLE_S = 4;
    private static final int APPROACHES = 4;
    private static final double PROGRESS_MM = 50;
    private static final double BLOCKED_S = 3;

    /** A take-off waits for its motors to gain speed, seconds. */
    private static final double TAKE_OFF_S = 8;

    private final VehicleSession session;
    private final FlightGuard flight;
    private final ObstructionSource obstructions;
    private final VelocityTargets output;
    private final Runnable halt;
    private final Motion motion;
    private final RenewalWatch renewals;
    private final double fromMm;
    private double sentMmPerSec;
    private double progressMm;
    private double progressS;

    /**
     * Begins with the present height.
     *
     * @param halt stops the copter where it is
     */
    HeightControl(
            VehicleSession session,
            FlightGuard flight,
            ObstructionSource obstructions,
            VelocityTargets output,
            Runnable halt,
            Motion motion,
            TimeSource time) {
        this.session = session;
        this.flight = flight;
        this.obstructions = obstructions;
        this.output = output;
        this.halt = halt;
        this.motion = motion;
        this.renewals = new RenewalWatch(time);
        this.fromMm = flight.heightMm();
        this.progressMm = fromMm;
        this.progressS = motion.seconds();
    }

    /**
     * Climbs.
     *
     * @param mm up positive
     * @return the change of the height
     * @throws MotionFailed if something ended it, or the height was missed by more than 300 mm
     */
    Value climb(double mm) {
        double toMm = fromMm + mm;
        for (int approach = 0; approach < APPROACHES && Math.abs(leftMm(toMm)) > ACCEPTABLE_MM; approach++) {
            if (!approach(toMm) || !settle()) {
                motion.send(halt);
                return covered();
            }
        }
        if (Math.abs(leftMm(toMm)) > TOLERABLE_MM) {
            throw failed("the height was missed by more than " + Value.of(TOLERABLE_MM, Unit.MM));
        }
        return covered();
    }

    private double leftMm(double toMm) {
        return toMm - flight.heightMm();
    }

    private Value covered() {
        return Value.of(flight.heightMm() - fromMm, Unit.MM);
    }

    private boolean approach(double toMm) {
        double direction = Math.signum(leftMm(toMm));
        ApproachPlan plan = new ApproachPlan(CRUISE_MM_PER_SEC, CREEP_MM_PER_SEC, ACCELERATION_MM_PER_SEC2);
        while (true) {
            failIfLate();
            check(BLOCKED_S);
            GlobalPosition now = flight.position();
            double left = direction * (toMm - now.aboveHomeMm() + DELAY_S * now.downMmPerSec());
            if (left <= REACHED_MM) {
                return true;
            }
            double most = Math.abs(sentMmPerSec) + ACCELERATION_MM_PER_SEC2 * PERIOD_S;
            send(direction * Math.min(most, plan.rate(left, 1, 1)));
            if (!motion.pause(PERIOD_S)) {
                return false;
            }
        }
    }

    private boolean settle() {
        double beginS = motion.seconds();
        double restsS = beginS;
        while (motion.seconds() - restsS < SETTLE_S / 8) {
            send(0);
            if (!motion.pause(PERIOD_S)) {
                return false;
            }
            failIfLate();
            check(SETTLE_S + BLOCKED_S);
            boolean rests = Math.abs(flight.position().downMmPerSec()) < RESTING_MM_PER_SEC;
            restsS = rests ? restsS : motion.seconds();
            if (motion.seconds() - beginS > SETTLE_S) {
                throw failed("it does not come to rest");
            }
        }
        progressS = motion.seconds();
        return true;
    }

    /** Sends the next velocity, unless the program has not run for a while: nothing goes on by itself then. */
    private void send(double mmPerSec) {
        sentMmPerSec = mmPerSec;
        motion.send(() -> {
            if (renewals.late() == null) {
                renewals.renewed();
                output.climb(mmPerSec);
            }
        });
        failIfLate();
    }

    private void failIfLate() {
        String late = renewals.late();
        if (late != null) {
            throw failed(late);
        }
    }

    private void check(double blockedS) {
        Obstruction found = obstructions.newest();
        if (found != null) {
            throw failed(found.what());
        }
        double heightMm = flight.heightMm();
        if (Math.abs(heightMm - progressMm) >= PROGRESS_MM) {
            progressMm = heightMm;
            progressS = motion.seconds();
        }
        if (motion.seconds() - progressS > blockedS) {
            throw failed("its height does not change");
        }
    }

    private MotionFailed failed(String reason) {
        motion.send(halt);
        return new MotionFailed(reason + " after " + covered());
    }

    /**
     * Takes off, and waits until the height is reached.
     *
     * @param toMm above home, mm
     * @param brake stops it where the guard of the motion has ended it
     * @return the height
     * @throws MotionFailed if the autopilot refuses it, or something ended it
     */
    Value takeOff(double toMm, Runnable brake) {
        boolean sent =
                session.commands().run(motion, "take off", MavlinkRequests.TAKE_OFF, 0, 0, 0, 0, 0, 0, toMm / 1000);
        while (sent && motion.pause(PERIOD_S)) {
            check(TAKE_OFF_S);
            GlobalPosition now = flight.position();
            boolean isThere = now.aboveHomeMm() > toMm - TOLERABLE_MM;
            if (isThere && Math.abs(now.downMmPerSec()) < RESTING_MM_PER_SEC && !flight.isOnGround()) {
                return Value.of(now.aboveHomeMm(), Unit.MM);
            }
        }
        motion.send(brake);
        return Value.of(flight.heightMm(), Unit.MM);
    }
}
