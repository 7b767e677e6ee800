package majicsim.mavlink;

import java.util.ArrayList;
import java.util.List;

/** The start of the firmware, with the texts and times of a captured start (sheet 12): 44 s until arming works. */
final class Boot {
    private static final double INITIALISED_S = 2.28;
    private static final double FIX_S = 10.26;
    private static final double ORIGIN_S = 19.76;
    private static final double POSITION_S = 42;
    private static final double ARMABLE_S = 44;
    private static final double REMINDER_S = 30;

    private static final List<Step> SCRIPT = List.of(
            new Step(0.01, "Calibrating barometer"),
            new Step(1.61, "Barometer 1 calibration complete"),
            new Step(1.65, "Beginning INS calibration. Do not move vehicle"),
            new Step(INITIALISED_S, "ArduPilot Ready"),
            new Step(INITIALISED_S, "AHRS: DCM active"),
            new Step(4.29, "EKF3 IMU0 initialised"),
            new Step(5.88, "EKF3 IMU0 tilt alignment complete"),
            new Step(5.97, "EKF3 IMU0 MAG0 initial yaw alignment complete"),
            new Step(9.57, "GPS 1: detected u-blox"),
            new Step(ORIGIN_S, "EKF3 IMU0 origin set"),
            new Step(19.86, "Field Elevation Set: 584m"),
            new Step(POSITION_S, "EKF3 IMU0 is using GPS"),
            new Step(POSITION_S, "AHRS: EKF3 active"));
    private static final List<Step> READY_SCRIPT = List.of(new Step(0, "ArduPilot Ready"));

    private static final List<Failure> FAILURES = List.of(
            new Failure(0, 14, "Accels inconsistent"),
            new Failure(14, 26, "Gyros inconsistent"),
            new Failure(4.3, FIX_S, "AHRS: waiting for home"),
            new Failure(FIX_S, ARMABLE_S, "AHRS: not using configured AHRS type"));

    private final boolean isReady;
    private final Announcements announcements;
    private long nanos;
    private int said;
    private double nextReminderS;

    private record Step(double atS, String text) {}

    private record Failure(double fromS, double toS, String text) {}

    /** A start that takes its time, or with {@code isReady} one that is over at once. */
    Boot(boolean isReady, Announcements announcements) {
        this.isReady = isReady;
        this.announcements = announcements;
        restart();
    }

    void restart() {
        nanos = 0;
        said = 0;
        nextReminderS = REMINDER_S;
    }

    void step(double stepSeconds) {
        nanos += Math.round(stepSeconds * 1e9);
        double seconds = seconds();
        List<Step> script = isReady ? READY_SCRIPT : SCRIPT;
        while (said < script.size() && script.get(said).atS() <= seconds) {
            announcements.say(Announcements.INFO, script.get(said).text());
            said++;
        }
        if (seconds >= nextReminderS) {
            nextReminderS += REMINDER_S;
            armingFailures().forEach(text -> announcements.say(Announcements.CRITICAL, "PreArm: " + text));
        }
    }

    /** The time since the start. */
    double seconds() {
        return nanos / 1e9;
    }

    long nanos() {
        return nanos;
    }

    long millis() {
        return nanos / 1_000_000;
    }

    /** Whether modes can be chosen. */
    boolean isInitialised() {
        return has(INITIALISED_S);
    }

    /** Whether there are satellites, and a home. */
    boolean hasFix() {
        return has(FIX_S);
    }

    /** Whether the position filter has its origin. */
    boolean hasOrigin() {
        return has(ORIGIN_S);
    }

    /** Whether the position filter uses the satellites. */
    boolean hasPosition() {
        return has(POSITION_S);
    }

    boolean isOver() {
        return has(ARMABLE_S + 1);
    }

    /** Why the vehicle cannot be armed now; empty if it can. */
    List<String> armingFailures() {
        List<String> texts = new ArrayList<>();
        double seconds = seconds();
        if (!isReady) {
            FAILURES.stream()
                    .filter(failure -> seconds >= failure.fromS() && seconds < failure.toS())
                    .forEach(failure -> texts.add(failure.text()));
        }
        return texts;
    }

    private boolean has(double atS) {
        return isReady || seconds() >= atS;
    }
}
