package majic.ros;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import majic.bot.Unit;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;

/** The steps that the tests with the simulated ROS robot share. */
final class RosLabSteps {
    /** The wall ahead of a robot on the line y = 0. */
    static final double WALL_X_MM = 4500;

    private RosLabSteps() {}

    /** Connects the robot of a stepped lab without noise, which looks at the wall. */
    static LabRobot connected(String model, double xMm) {
        LabRobot robot = new LabRobot("ros", LabRig.exactWithRos(model)).at(xMm, 0, 0);
        robot.bot().connect();
        return robot;
    }

    /** Runs a command of the robot. */
    static String run(LabRobot robot, String command, Object... arguments) {
        Stream<Value> values = Arrays.stream(arguments)
                .map(argument -> argument instanceof Integer number
                        ? Value.of(number, Unit.NONE)
                        : Value.text(argument.toString()));
        return robot.bot().run(command, values.toList());
    }

    /** Runs a command on a thread that uses the clock of the lab. */
    static CompletableFuture<String> aside(LabRobot robot, String command, Object... arguments) {
        CompletableFuture<String> outcome = new CompletableFuture<>();
        robot.bot()
                .time()
                .thread("command", () -> outcome.completeAsync(() -> run(robot, command, arguments), Runnable::run))
                .start();
        return outcome;
    }

    /** Lets time of the lab pass. */
    static void pass(LabRobot robot, double seconds) {
        try {
            robot.bot().time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Returns the true distance from the hull to the wall ahead. */
    static double frontMm(LabRobot robot) {
        return WALL_X_MM - robot.truePose().xMm() - robot.bot().profile().bodyMm();
    }
}
