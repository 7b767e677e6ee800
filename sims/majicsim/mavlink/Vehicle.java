package majicsim.mavlink;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What the firmware of a rover and a copter have in common: arming, modes, and the failsafe of the ground station. */
abstract class Vehicle {
    /** The bits of base_mode (sheet 3). */
    static final int CUSTOM = 1;

    static final int GUIDED_BY_ITSELF = 8;
    static final int STABILIZED = 16;
    static final int MANUAL_INPUT = 64;
    private static final int ARMED = 128;

    /** The numbers of system_status (sheet 3). */
    static final int STANDBY = 3;

    static final int ACTIVE = 4;
    private static final int CALIBRATING = 2;
    private static final int CRITICAL = 5;

    private final Board board;
    private boolean armed;
    private boolean failsafe;

    Vehicle(Board board) {
        this.board = board;
    }

    Board board() {
        return board;
    }

    double parameter(String name) {
        return board.parameter(name);
    }

    void say(int severity, String text) {
        board.announcements().say(severity, text);
    }

    /** Lets time pass, of which the start-up and the world have already taken their part. */
    final void step(double seconds) {
        watchGroundStation();
        move(seconds);
        board.battery().step(amperes(), seconds);
    }

    private void watchGroundStation() {
        boolean isLost =
                parameter("FS_GCS_ENABLE") != 0 && board.groundStation().isSilentFor(failsafeDelayS());
        if (isLost && !failsafe && heedsFailsafe()) {
            failsafe = true;
            enterFailsafe();
        } else if (!isLost && failsafe) {
            failsafe = false;
            say(Announcements.WARNING, "GCS Failsafe Cleared");
        }
    }

    /** Drives or flies for a while, by mode and targets. */
    abstract void move(double seconds);

    /** The current that it draws now. */
    abstract double amperes();

    /** How long the ground station may be silent. */
    abstract double failsafeDelayS();

    /** Whether the silence of the ground station matters in the present mode. */
    abstract boolean heedsFailsafe();

    /** Does what the parameters say about a silent ground station, and reports it. */
    abstract void enterFailsafe();

    abstract Motion motion();

    /** Whether it does not move, and cannot until it is armed. */
    abstract boolean isResting();

    /** The number of its mode. */
    abstract int mode();

    abstract boolean isMode(int number);

    /** Enters a mode that exists; returns false, with a text if there is a reason, if it stays in the present one. */
    abstract boolean enter(int number);

    /** The mode of a command; -1 if it has none. */
    abstract int landingMode();

    abstract int returningMode();

    abstract int guidedMode();

    /** The bits of base_mode apart from that for armed. */
    abstract int modeBits();

    /** The status when there is nothing special. */
    abstract int usualStatus();

    /** As in EXTENDED_SYS_STATE. */
    abstract int landedState();

    /** 0 to 100. */
    abstract int throttlePercent();

    /** Takes a target, or drops it in silence. */
    abstract void aim(PositionTarget target);

    /** What it aims at, in m from the origin; null if at nothing. */
    abstract @Nullable PositionTarget aimed();

    /** Goes to a place, in m from the origin and above the floor, if it is in the guided mode. */
    abstract boolean goTo(double north, double east, double height);

    /** Sets the speed on the way to a place. */
    abstract boolean speed(double metresPerSec);

    abstract CommandResult takeOff(double metresAboveHome);

    /** Why it cannot be armed for reasons of its kind. */
    abstract List<String> ownArmingFailures();

    /** Whether a plain disarm is refused now. */
    abstract boolean refusesDisarm();

    /** It has just been armed or disarmed. */
    abstract void armedChanged();

    /** It has been started anew. */
    abstract void restarted();

    /** Changes the mode by order of a ground station or of the pilot. */
    final CommandResult change(int number) {
        if (!board.boot().isInitialised()) {
            return CommandResult.FAILED;
        }
        if (!isMode(number)) {
            say(Announcements.WARNING, "No such mode " + number);
            return CommandResult.FAILED;
        }
        return number == mode() || enter(number) ? CommandResult.ACCEPTED : CommandResult.FAILED;
    }

    final CommandResult arm(boolean isForced) {
        if (armed) {
            return CommandResult.ACCEPTED;
        }
        if (!isForced) {
            List<String> failures = board.boot().armingFailures();
            failures.addAll(ownArmingFailures());
            if (!failures.isEmpty()) {
                failures.forEach(text -> say(Announcements.CRITICAL, "Arm: " + text));
                return CommandResult.FAILED;
            }
        }
        armed = true;
        board.filter().home(motion());
        armedChanged();
        return CommandResult.ACCEPTED;
    }

    final CommandResult disarm(boolean isForced) {
        if (armed && !isForced && refusesDisarm()) {
            return CommandResult.FAILED;
        }
        if (armed) {
            armed = false;
            armedChanged();
        }
        return CommandResult.ACCEPTED;
    }

    final boolean isArmed() {
        return armed;
    }

    final void restart() {
        armed = false;
        failsafe = false;
        restarted();
    }

    final int baseMode() {
        return modeBits() | CUSTOM | (armed ? ARMED : 0);
    }

    final int systemStatus() {
        if (!board.boot().isInitialised()) {
            return CALIBRATING;
        }
        return failsafe ? CRITICAL : usualStatus();
    }
}
