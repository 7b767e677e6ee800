package majic.pioneer.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Gripper;

/**
 * The commands that move gripper and lift. Both can pinch, so the commands need permission to move, run one at a time,
 * and end at a stop. Thread-safe.
 */
final class GripperCommands {
    /** Longer than the lift takes all the way, seconds. */
    private static final double LONGEST_S = 12;

    /** The first reports after the command may be older than it, seconds. */
    private static final double LATENCY_S = 0.3;

    private static final String UNREPORTED = "sent; this robot does not report the state of its gripper";
    private static final int CARRY = 17;
    private static final int LONGEST_CARRY_MS = 5100;

    private final PioneerAccess access;
    private volatile boolean mayMove;

    GripperCommands(PioneerAccess access) {
        this.access = access;
    }

    DriverCommand gripper() {
        return new DriverCommand(
                "gripper",
                List.of(Parameter.choice("order", Action.words(), "what to do")),
                true,
                "open, close, up, down (the lift), store (close and up), deploy (open and down) or stop",
                (arguments, motion) -> run(Action.of(arguments.get(0).toString()), motion));
    }

    DriverCommand carry() {
        Parameter time = Parameter.number("time", Unit.MS, "how long").within(-LONGEST_CARRY_MS, LONGEST_CARRY_MS);
        return new DriverCommand(
                "carry",
                List.of(time),
                true,
                "the lift goes up for a time (20ms … 5.1s), or down for a negative one",
                (arguments, motion) -> carry(arguments.get(0).number(), motion));
    }

    private String run(Action order, Motion motion) {
        mayMove = true;
        motion.send(() -> access.send(ArcosCommand.GRIPPER.packet(order.argument())));
        motion.pause(LATENCY_S);
        boolean done = motion.await(() -> state().filter(order::isDone).isPresent(), LONGEST_S);
        if (!done && state().filter(GripperCommands::isReporting).isPresent()) {
            throw new MotionFailed("not done within " + Value.plain(LONGEST_S) + " s: " + words());
        }
        mayMove = false;
        return done ? words() : UNREPORTED;
    }

    private String carry(double ms, Motion motion) {
        mayMove = true;
        int steps = (int) Math.round(ms / GripperParameters.STEP_MS);
        motion.send(() -> {
            access.send(ArcosCommand.GRIPPER.packet(CARRY));
            access.send(ArcosCommand.GRIPPERVAL.packet(steps));
        });
        motion.pause(Math.abs(ms) / 1000);
        mayMove = false;
        return state().map(now -> "lift " + GripperParameters.lift(now)).orElse(UNREPORTED);
    }

    /** Stops gripper and lift if they may be moving; waits for nothing. */
    void halt() {
        if (mayMove) {
            mayMove = false;
            access.send(ArcosCommand.GRIPPER.packet(Action.STOP.argument()));
        }
    }

    private Optional<Gripper> state() {
        return access.open().state().gripper();
    }

    /** A gripper whose flags are all clear is taken not to report its state (ARCOS sheet 17). */
    private static boolean isReporting(Gripper gripper) {
        return gripper.open() || gripper.closed() || gripper.moving() || gripper.liftUp() || gripper.liftDown();
    }

    private String words() {
        return state().map(now -> "gripper " + GripperParameters.paddles(now) + ", lift " + GripperParameters.lift(now))
                .orElse(UNREPORTED);
    }

    /** What gripper and lift can do, with the argument of the command (ARCOS sheet 11.5). */
    private enum Action {
        /** Paddles apart. */
        OPEN(1, Gripper::open),
        /** Paddles together, or on an object between them. */
        CLOSE(2, Gripper::closed),
        /** Lift all the way up. */
        UP(4, Gripper::liftUp),
        /** Lift all the way down. */
        DOWN(5, Gripper::liftDown),
        /** Closed and up, for driving. */
        STORE(7, gripper -> gripper.closed() && gripper.liftUp()),
        /** Open and down, for gripping. */
        DEPLOY(8, gripper -> gripper.open() && gripper.liftDown()),
        /** Stop both. */
        STOP(15, gripper -> true);

        private final int argument;
        private final Predicate<Gripper> end;

        Action(int argument, Predicate<Gripper> end) {
            this.argument = argument;
            this.end = end;
        }

        static Action of(String word) {
            return valueOf(word.toUpperCase(Locale.ROOT));
        }

        static List<String> words() {
            return Arrays.stream(values()).map(Action::word).toList();
        }

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        int argument() {
            return argument;
        }

        /** Whether the action is done and nothing moves any more. */
        boolean isDone(Gripper gripper) {
            return end.test(gripper) && !gripper.moving() && !gripper.liftMoving();
        }
    }
}
