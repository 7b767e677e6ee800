package majic.ros.parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.ros.message.OdometryMessage;
import majic.ros.navigation.Navigation;
import majic.ros.navigation.Navigation.Target;
import majic.ros.navigation.NavigationServers;
import majic.ros.readings.RosReadings;

/** Commands that leave the way to the robot's own navigation. */
final class GoalCommands {
    private static final double FARTHEST_MM = 1_000_000;

    /** The end of a goal may be reported before the robot is at rest. */
    private static final double REST_S = 4;

    /** Navigations count as arrived within 250 mm, and the odometry drifts by some percent of the way. */
    private static final double TOLERANCE_MM = 500;

    private static final double DRIFT = 0.05;

    private final RosAccess access;
    private final Navigation navigation;
    private final Supplier<BotState> state;

    /**
     * Creates the commands.
     *
     * @param state the newest state of the robot
     */
    GoalCommands(RosAccess access, Navigation navigation, Supplier<BotState> state) {
        this.access = access;
        this.navigation = navigation;
        this.state = state;
    }

    void describe(ParameterTable table, NavigationServers servers) {
        if (servers.canNavigate()) {
            table.add(
                    Parameter.number("goalLeft", Unit.MM, "how far the goal of goto still is"),
                    () -> navigation.leftMm().isPresent()
                            ? Value.of(navigation.leftMm().getAsDouble(), Unit.MM)
                            : Value.unknown(navigation.isPursuing() ? "the robot does not report it" : "no goal"));
        }
    }

    List<DriverCommand> with(NavigationServers servers) {
        List<DriverCommand> commands = new ArrayList<>();
        if (servers.canNavigate()) {
            commands.add(new DriverCommand(
                    "goto",
                    place(),
                    true,
                    "drives to a place by the robot's own navigation, around obstacles; x and y as in pose",
                    (values, motion) -> goHere(servers, values, motion)));
            commands.add(new DriverCommand(
                    "gotoMap",
                    place(),
                    true,
                    "the same with x and y in the robot's own map",
                    (values, motion) -> go(servers, new Target("map", target(values, 0)), motion)));
        }
        servers.dock().ifPresent(action -> commands.add(simple("dock", "Dock", action, "drives onto the charger")));
        servers.undock().ifPresent(action -> commands.add(simple("undock", "Undock", action, "leaves the charger")));
        return commands;
    }

    private static List<Parameter> place() {
        return List.of(
                Parameter.number("x", Unit.MM, "ahead of the start").within(-FARTHEST_MM, FARTHEST_MM),
                Parameter.number("y", Unit.MM, "to the left of it")
                        .within(-FARTHEST_MM, FARTHEST_MM)
                        .with(Parameter.number("heading", Unit.DEG, "at the end; without it, that of the way")
                                .within(-360, 360)));
    }

    private static Pose target(List<Value> values, double wayDeg) {
        return new Pose(
                values.get(0).number(),
                values.get(1).number(),
                values.size() > 2 ? values.get(2).number() : wayDeg);
    }

    /**
     * The place in the frame of the odometry: the robot is known in both frames at this moment. Navigation converts it
     * into the frame of its map.
     */
    private Target here(List<Value> values) {
        OdometryMessage odometry = access.open()
                .odometry()
                .orElseThrow(() -> new BotException("the robot has not reported its odometry yet"));
        Pose now = state.get().pose();
        double wayDeg = Math.toDegrees(
                Math.atan2(values.get(1).number() - now.yMm(), values.get(0).number() - now.xMm()));
        Pose inOdometry = odometry.pose().originOf(now).plus(target(values, wayDeg));
        return new Target(odometry.frame().isEmpty() ? "odom" : odometry.frame(), inOdometry);
    }

    /** Drives to a place in the frame of the odometry, which shows whether the robot is there. */
    private String goHere(NavigationServers servers, List<Value> values, Motion motion) {
        Pose target = target(values, 0);
        double wayMm = state.get().pose().distanceMm(target);
        String arrived = go(servers, here(values), motion);
        double leftMm = state.get().pose().distanceMm(target);
        if (!motion.guardReached() && leftMm > TOLERANCE_MM + DRIFT * wayMm) {
            throw new MotionFailed("the navigation of the robot reports its arrival, but by its odometry the robot is "
                    + Value.of(leftMm, Unit.MM) + " from there: " + arrived);
        }
        return arrived;
    }

    private String go(NavigationServers servers, Target target, Motion motion) {
        RosReadings open = access.open();
        navigation.drive(open.connection(), servers, target, motion);
        if (!motion.await(() -> !state.get().moving(), REST_S) && !motion.guardReached()) {
            throw new MotionFailed("the navigation of the robot reports its arrival, but the robot moves on");
        }
        Pose there = state.get().pose();
        return (motion.guardReached() ? "ended at " : "arrived at ") + Value.of(there.xMm(), Unit.MM) + ", "
                + Value.of(there.yMm(), Unit.MM) + ", " + Value.of(there.headingDeg(), Unit.DEG);
    }

    private DriverCommand simple(String name, String type, String action, String help) {
        return new DriverCommand(name, List.of(), true, help, (values, motion) -> {
            navigation.perform(access.open().connection(), action, "irobot_create_msgs/action/" + type, motion);
            return name.equals("dock") ? "docked" : "undocked";
        });
    }
}
