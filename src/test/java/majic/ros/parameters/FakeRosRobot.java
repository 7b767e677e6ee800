package majic.ros.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.ros.RosType;
import majic.ros.message.CompressedPicture;
import majic.ros.message.OdometryMessage;
import majic.ros.navigation.Navigation;
import majic.ros.navigation.NavigationServers;
import majic.ros.readings.FakeRosClient;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;
import majic.time.Signal;

/** A connected driver with the parameters and commands of a ROS robot, over a connection that the test plays. */
public final class FakeRosRobot implements AutoCloseable {
    private final TestClock clock = new TestClock();
    private final FakeRosClient client;
    private final Driver driver;
    private volatile RosReadings readings;

    FakeRosRobot(FakeRosClient client) {
        this.client = client;
        this.driver = new Driver(new BotEnvironment(clock.time(), Settings.inMemory()));
        driver.connect();
        sensors(client.topics());
    }

    FakeRosClient client() {
        return client;
    }

    BotDriver bot() {
        return driver;
    }

    TestClock clock() {
        return clock;
    }

    int halts() {
        return driver.halts.get();
    }

    void sensors(Map<String, String> topics) {
        sensors(RosSensors.of(topics, ""));
    }

    void sensors(RosSensors sensors) {
        readings = new RosReadings(
                client, sensors, new RobotWait(clock.time(), driver.signal()), new RosReadings.Events() {
                    @Override
                    public void news() {}

                    @Override
                    public void picture(CompressedPicture picture) {}

                    @Override
                    public void scanned(RangeSensor sensor, long measuredNanos, float... rangesMm) {}

                    @Override
                    public void notice(String message) {}
                });
        readings.begin();
        driver.describe(sensors, NavigationServers.of(client.topics(), List.of(), ""));
    }

    /** Offers the servers of actions of ROS 2. */
    void actions(String... names) {
        driver.describe(RosSensors.NONE, NavigationServers.of(client.topics(), List.of(names), ""));
    }

    void odometry(OdometryMessage newest) {
        readings.odometry(newest);
    }

    void at(Pose pose) {
        driver.at(pose);
    }

    String run(String command, String... arguments) {
        return driver.run(
                command, Arrays.stream(arguments).map(FakeRosRobot::value).toList());
    }

    private static Value value(String typed) {
        return typed.matches("-?\\d+") ? Value.of(Double.parseDouble(typed), Unit.NONE) : Value.text(typed);
    }

    CompletableFuture<String> aside(Supplier<String> command) {
        return clock.aside(command);
    }

    @Override
    public void close() {
        driver.close();
        clock.close();
    }

    /** Does nothing but what parameters and commands need. */
    private final class Driver extends BotDriver {
        private final AtomicInteger halts = new AtomicInteger();
        private final Navigation navigation = new Navigation(changes());
        private final RosParameters parameters = new RosParameters(
                table(), new RosAccess(() -> readings), navigation, changes(), () -> 100, this::state);

        Driver(BotEnvironment environment) {
            super(
                    new RosType(),
                    new BotProfile(100, new Range(-300, 300), new Range(-90, 90), 100, 45, 100, false),
                    environment);
        }

        Signal signal() {
            return changes();
        }

        void describe(RosSensors sensors, NavigationServers servers) {
            parameters.describe(sensors, servers);
            RosParameters.COMMANDS.forEach(this::removeCommand);
            parameters.commands(servers).forEach(this::add);
        }

        void at(Pose pose) {
            publish(new BotState(pose, 0, 0, false, time().nanos()));
        }

        @Override
        protected void open() {}

        @Override
        protected void shut() {}

        @Override
        protected Value moveBy(double mm, Motion motion) {
            return Value.of(0, Unit.MM);
        }

        @Override
        protected Value turnBy(double degrees, Motion motion) {
            return Value.of(0, Unit.DEG);
        }

        @Override
        protected void driveAt(double mmPerSec, double degPerSec) {}

        @Override
        protected void halt() {
            halts.incrementAndGet();
            client.publish("/cmd_vel", "geometry_msgs/Twist", FakeRosClient.json("{}"));
            navigation.cancel();
        }
    }
}
