package majic.gui.drive;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.swing.Timer;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Drives robots while arrows are held, and releases them when they are not. Runs on the event dispatch thread and never
 * blocks there: if that thread hangs, the commands are not renewed and the robots stop 600 ms later.
 */
final class ManualDriver {
    private static final int TICK_MS = 25;

    private final GuardChoice guard;
    private final Consumer<String> errors;
    private final LongSupplier clockMs;
    private final HeldKeys keys = new HeldKeys();
    private final Timer ticks = new Timer(TICK_MS, event -> tick());
    private List<DrivenRobot> robots = List.of();
    private @Nullable Direction pointed;
    private boolean ignoresHeldArrows;
    private double share = 1;

    /**
     * Creates a driver without robots.
     *
     * @param guard whether the robots are guarded
     * @param errors receives the reason when a robot cannot be driven
     * @param clockMs any clock that does not go back
     */
    ManualDriver(GuardChoice guard, Consumer<String> errors, LongSupplier clockMs) {
        this.guard = guard;
        this.errors = errors;
        this.clockMs = clockMs;
    }

    /**
     * Chooses the robots to drive. If arrows are held at the moment, the driven robots stop, and the arrows drive none
     * until all of them have been released once.
     */
    void choose(List<Member> members) {
        if (members.equals(robots.stream().map(DrivenRobot::member).toList())) {
            return;
        }
        List<DrivenRobot> chosen = new ArrayList<>();
        for (Member member : members) {
            chosen.add(robots.stream()
                    .filter(robot -> robot.member() == member)
                    .findFirst()
                    .orElseGet(() -> new DrivenRobot(member, guard, errors, clockMs)));
        }
        robots.forEach(DrivenRobot::release);
        robots = List.copyOf(chosen);
        ignoresHeldArrows = ticks.isRunning();
    }

    void keyPressed(Direction key) {
        keys.press(key, clockMs.getAsLong());
        begin();
    }

    void keyReleased(Direction key) {
        keys.release(key, clockMs.getAsLong());
    }

    /** Sets the arrow on which the mouse is pressed; null for none. */
    void point(@Nullable Direction arrow) {
        pointed = arrow;
        begin();
    }

    /** Stops at once, regardless of the keys held; called when the focus is lost or the panel is hidden. */
    void stopDriving() {
        keys.releaseAll();
        pointed = null;
        tick();
    }

    /** Sets the speed as a share of the cruise speed in the robot's profile, 0 to 1. */
    void share(double newShare) {
        share = newShare;
    }

    private void begin() {
        tick();
        if (!ticks.isRunning()) {
            ticks.start();
        }
    }

    private Set<Direction> wanted() {
        Set<Direction> all = EnumSet.noneOf(Direction.class);
        all.addAll(keys.held(clockMs.getAsLong()));
        if (pointed != null) {
            all.add(pointed);
        }
        return all;
    }

    private void tick() {
        Set<Direction> wanted = wanted();
        if (wanted.isEmpty()) {
            ticks.stop();
            ignoresHeldArrows = false;
            robots.forEach(DrivenRobot::release);
        } else if (!ignoresHeldArrows) {
            double forward = share * Direction.forward(wanted);
            double left = share * Direction.left(wanted);
            robots.forEach(robot -> robot.drive(forward, left));
        }
    }
}
