package majic.ros.parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import majic.bot.BotState;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.navigation.Navigation;
import majic.ros.navigation.NavigationServers;
import majic.ros.readings.RosSensors;
import majic.time.Signal;

/**
 * The parameters and commands of a ROS robot besides those that every robot has. Which there are depends on the sensors
 * that were found while the robot was connected, so a script that uses others is refused before anything moves.
 */
public final class RosParameters {
    /** The names of all commands. */
    public static final List<String> COMMANDS = List.of("topics", "topic", "call", "goto", "gotoMap", "dock", "undock");

    private final ParameterTable table;
    private final List<ParameterTheme<RosSensors>> themes;
    private final TopicCommands topics;
    private final CallCommand call;
    private final GoalCommands goals;

    /**
     * Describes a robot without sensors, until {@link #describe} is called.
     *
     * @param table lists the parameters
     * @param access gives the readings of the present connection
     * @param navigation pursues the goals of commands
     * @param changes the signal that all threads waiting for the robot wait on
     * @param radiusMm of the robot
     * @param state the newest state of the robot
     */
    public RosParameters(
            ParameterTable table,
            RosAccess access,
            Navigation navigation,
            Signal changes,
            DoubleSupplier radiusMm,
            Supplier<BotState> state) {
        this.table = table;
        RosReportedParameters reported = new RosReportedParameters(access);
        this.themes = List.of(
                new RosRangingParameters(access, radiusMm),
                reported::contacts,
                reported::power,
                reported::inertial,
                new RosJointParameters(access),
                reported::camera);
        this.topics = new TopicCommands(access);
        this.call = new CallCommand(access, changes);
        this.goals = new GoalCommands(access, navigation, state);
        table.findOthers(new TopicParameters(access));
    }

    /**
     * Describes what a robot has, and nothing else.
     *
     * @param sensors of the robot
     * @param servers for its goals
     */
    public void describe(RosSensors sensors, NavigationServers servers) {
        table.renew(fresh -> {
            themes.forEach(theme -> theme.describe(fresh, sensors));
            goals.describe(fresh, servers);
        });
    }

    /**
     * Returns the commands of a robot.
     *
     * @param servers for its goals
     * @return in the order of the listing
     */
    public List<DriverCommand> commands(NavigationServers servers) {
        List<DriverCommand> all = new ArrayList<>(goals.with(servers));
        all.add(topics.topics());
        all.add(topics.topic());
        all.add(call.command());
        return all;
    }
}
