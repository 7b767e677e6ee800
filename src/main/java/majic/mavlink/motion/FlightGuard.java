package majic.mavlink.motion;

import java.util.Locale;
import java.util.function.Supplier;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.mavlink.message.AttitudeReport;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.LandedState;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.motion.FlightFence.Place;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.velocity.Obstruction;
import majic.velocity.Obstruction.Side;
import majic.velocity.ObstructionSource;
import org.jspecify.annotations.Nullable;

/**
 * Decides whether MAJIC may fly a copter: armed by MAJIC's command during this connection, in the air, inside the fence
 * that the user has set. Home is where it was armed. Thread-safe; sends nothing.
 */
final class FlightGuard implements ObstructionSource {
    /** A height that is older ends a motion, seconds. */
    private static final double OLD_S = 1;

    /** What the wander of the position and the end of a motion may go beyond the fence, mm. */
    private static final double MARGIN_MM = 500;

    /** From a stop to its effect, seconds, and the deceleration then. */
    private static final double STOP_S = 0.3;

    private static final double BRAKING_MM_PER_SEC2 = 2000;
    private static final double LANDED_S = 3;

    private final VehicleSession session;
    private final TimeSource time;
    private final Supplier<@Nullable FlightFence> fence;
    private volatile @Nullable GlobalPosition home;
    private volatile @Nullable Pose homeInOdometry;
    private volatile @Nullable String ended;
    private volatile boolean takingOff;

    FlightGuard(VehicleSession session, TimeSource time, Supplier<@Nullable FlightFence> fence) {
        this.session = session;
        this.time = time;
        this.fence = fence;
    }

    /** Takes note that MAJIC's command has armed it, where it is. */
    void armed(GlobalPosition where) {
        homeInOdometry = session.reports()
                .newest(LocalPosition.class, OLD_S)
                .filter(LocalPosition::isUsable)
                .map(position -> new Pose(1000 * position.northM(), -1000 * position.eastM(), 0))
                .orElse(null);
        home = where;
    }

    /** Takes note that it is not armed, or was not for a moment: a watchdog may restart an autopilot in the air. */
    void disarmed() {
        home = null;
        homeInOdometry = null;
    }

    /** Where it was armed, in the frame of its odometry; null if it was not, or that is not known. */
    @Nullable
    Pose homeInOdometry() {
        return homeInOdometry;
    }

    boolean isArmedByMajic() {
        return home != null;
    }

    /** Whether it reports that it is on the ground; false if it reports nothing. */
    boolean isOnGround() {
        return session.reports()
                .newest(LandedState.class, LANDED_S)
                .filter(LandedState::isOnGround)
                .isPresent();
    }

    private boolean isInAir() {
        return session.reports()
                .newest(LandedState.class, LANDED_S)
                .filter(LandedState::isInAir)
                .isPresent();
    }

    /** Where it is on the earth, and how high. */
    GlobalPosition position() {
        GlobalPosition now = newestPosition();
        if (now == null) {
            throw new MotionFailed("the autopilot does not report its height and where it is on the earth");
        }
        return now;
    }

    private @Nullable GlobalPosition newestPosition() {
        return session.reports()
                .newest(GlobalPosition.class, OLD_S)
                .filter(GlobalPosition::isKnown)
                .orElse(null);
    }

    /** Its height above home, mm. */
    double heightMm() {
        return position().aboveHomeMm();
    }

    /**
     * Refuses to fly it.
     *
     * @throws MotionFailed if no fence is set, or MAJIC's command has not armed it
     */
    void failUnlessReady() {
        if (fence.get() == null) {
            throw new MotionFailed("no fence is set; \"set fence RADIUS LOWEST HIGHEST\" does that, in mm from its home"
                    + " position, and MAJIC flies it only inside");
        }
        if (!session.newestHeartbeat().armed()) {
            throw new MotionFailed("it is not armed; \"arm\" does that"
                    + session.texts().reasonsSince(time.nanos() - (long) (60 * 1e9)));
        }
        if (!isArmedByMajic()) {
            throw new MotionFailed("it was not armed by \"arm\" of this connection, so MAJIC does not fly it; land it,"
                    + " disarm it and arm it by \"arm\"");
        }
    }

    /**
     * Refuses motions in the air.
     *
     * @throws MotionFailed if it must not fly, or is not in the air
     */
    void failUnlessFlying() {
        failUnlessReady();
        if (!isInAir()) {
            throw new MotionFailed("it is not in the air; \"takeoff HEIGHT\" takes it there");
        }
    }

    /**
     * Refuses to take off.
     *
     * @param toMm height above home, mm
     * @throws MotionFailed if it must not fly, is in the air, or the height is outside the fence
     */
    void failUnlessGrounded(double toMm) {
        failUnlessReady();
        if (!isOnGround()) {
            throw new MotionFailed("it does not report that it is on the ground; \"climb MM\" changes its height");
        }
        Place now = place(position());
        refuse(required().outside(new Place(now.northMm(), now.eastMm(), toMm), 0));
    }

    /**
     * Refuses a motion that ends outside of the fence, or begins there.
     *
     * @param aheadMm how far it goes, ahead positive
     * @param upMm up positive
     * @throws MotionFailed if it does
     */
    void failIfOutside(double aheadMm, double upMm) {
        GlobalPosition now = position();
        String outside = required().outside(place(now), MARGIN_MM);
        if (outside != null) {
            throw new MotionFailed("it is outside of the fence (" + outside
                    + "); \"home\" or \"land\" brings it down, \"set fence\" sets a larger one");
        }
        if (aheadMm == 0 && upMm == 0) {
            return;
        }
        double yaw = Math.toRadians(session.reports()
                .newest(AttitudeReport.class, OLD_S)
                .filter(AttitudeReport::isUsable)
                .orElseThrow(() -> new MotionFailed("the autopilot reports no attitude"))
                .yawDeg());
        refuse(required()
                .outside(place(now).plus(aheadMm * Math.cos(yaw), aheadMm * Math.sin(yaw), upMm), endMargin(upMm)));
    }

    /** One that only goes straight may begin a little too low or too high, as its height wanders. */
    private static double endMargin(double upMm) {
        return upMm == 0 ? MARGIN_MM / 2 : 0;
    }

    private static void refuse(@Nullable String outside) {
        if (outside != null) {
            throw new MotionFailed("it would end outside of the fence: " + outside);
        }
    }

    private FlightFence required() {
        FlightFence set = fence.get();
        if (set == null) {
            throw new MotionFailed("no fence is set");
        }
        return set;
    }

    private Place place(GlobalPosition now) {
        GlobalPosition from = home;
        if (from == null) {
            throw new MotionFailed("it is not armed by MAJIC");
        }
        return new Place(from.northMm(now.latitudeE7()), from.eastMm(now.longitudeE7()), now.aboveHomeMm());
    }

    /** Lets a motion begin that was commanded anew: what has ended the one before does not end it. */
    void begins() {
        ended = null;
    }

    /** Takes note whether it is taking off, and so may be lower than the fence, as on the ground. */
    void takingOff(boolean now) {
        takingOff = now;
    }

    /**
     * Refuses to go on with a motion of several parts.
     *
     * @throws MotionFailed if it was ended from here
     */
    void failIfEnded() {
        String reason = ended;
        if (reason != null) {
            throw new MotionFailed(reason);
        }
    }

    /**
     * Takes a position while MAJIC moves it; on the reader thread.
     *
     * @return whether it leaves the fence, or can no longer stop inside, so that it must be stopped
     */
    boolean leaves() {
        FlightFence now = fence.get();
        GlobalPosition position = newestPosition();
        GlobalPosition from = home;
        if (now == null || position == null || from == null || ended != null) {
            return false;
        }
        Place stopped = place(position)
                .plus(way(position.northMmPerSec()), way(position.eastMmPerSec()), way(0.0 - position.downMmPerSec()));
        String outside = takingOff || isOnGround() ? now.above(stopped, MARGIN_MM) : now.outside(stopped, MARGIN_MM);
        if (outside != null) {
            ended = "it leaves the fence, so it was stopped: " + outside;
        }
        return outside != null;
    }

    /** How far it goes until it has stopped, mm. */
    private static double way(double mmPerSec) {
        return mmPerSec * STOP_S + mmPerSec * Math.abs(mmPerSec) / (2 * BRAKING_MM_PER_SEC2);
    }

    /**
     * Takes a text of the autopilot: the failsafe of the battery ends a motion. It may have begun to land, so nothing
     * changes its mode.
     */
    void said(String text) {
        String lower = text.toLowerCase(Locale.ROOT);
        boolean isFailsafe = lower.contains("failsafe") || lower.contains("is low") || lower.contains("is critical");
        if (lower.contains("batter") && isFailsafe) {
            ended = "the autopilot reports: " + text;
        }
    }

    @Override
    public @Nullable Obstruction newest() {
        String reason = ended;
        if (reason == null && newestPosition() == null) {
            reason = "its height has not been reported for 1 s";
        }
        return reason == null ? null : new Obstruction(reason, Side.ALL, false, time.nanos());
    }
}
