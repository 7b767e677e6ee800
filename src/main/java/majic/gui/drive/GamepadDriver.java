package majic.gui.drive;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import majic.team.Member;

/**
 * Drives robots by a game controller, as long as its button is held. Releasing the button, centring the stick or
 * unplugging the controller stops them. After another choice of robots, and at the beginning, the button must have been
 * released once. Must be used on the event dispatch thread: if that thread hangs, no command is renewed, and the robots
 * stop 600 ms later.
 */
final class GamepadDriver {
    private final GuardChoice guard;
    private final Consumer<String> errors;
    private final LongSupplier clockMs;
    private List<DrivenRobot> robots = List.of();
    private boolean wasReleased;

    GamepadDriver(GuardChoice guard, Consumer<String> errors, LongSupplier clockMs) {
        this.guard = guard;
        this.errors = errors;
        this.clockMs = clockMs;
    }

    /** Chooses the robots to drive; those driven at the moment stop. */
    void choose(List<Member> members) {
        if (!members.equals(robots.stream().map(DrivenRobot::member).toList())) {
            stop();
            robots = members.stream()
                    .map(member -> new DrivenRobot(member, guard, errors, clockMs))
                    .toList();
        }
    }

    /** Drives by a state of the controller; must be called again and again. */
    void drive(GamepadState state) {
        if (state.connected() && !state.held()) {
            wasReleased = true;
        }
        if (!state.connected()) {
            wasReleased = false;
        }
        if (state.drives() && wasReleased) {
            robots.forEach(robot -> robot.drive(state.forward(), state.left()));
        } else {
            robots.forEach(DrivenRobot::release);
        }
    }

    /** Stops at once, until the button has been released. */
    void stop() {
        wasReleased = false;
        robots.forEach(DrivenRobot::release);
    }
}
