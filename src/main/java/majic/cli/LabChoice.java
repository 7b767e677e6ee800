package majic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Map;
import java.util.Stack;
import java.util.function.Function;
import majic.program.UsageException;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.pioneer.PioneerRobot;
import majicsim.ros.options.RosOptions;
import majicsim.world.Room;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The options of a simulated lab, the same for {@code --lab} and for {@code lab}. */
final class LabChoice {
    private static final double SLOWEST = 0.01;
    private static final double FASTEST = 100;
    private static final String KTEAM = "kteam";

    @Option(names = "--exact", scope = ScopeType.INHERIT, description = "Switch all noise of the simulated lab off.")
    private boolean exact;

    @Option(
            names = "--seed",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "Choose the lab's noise; the same N repeats it (1).")
    private long seed = 1;

    @Option(
            names = "--world",
            scope = ScopeType.INHERIT,
            paramLabel = "FILE",
            description = "A map to drive in, in the Pioneer world's .map format.")
    private @Nullable Path world;

    @Option(
            names = "--speed",
            scope = ScopeType.INHERIT,
            paramLabel = "F",
            description = "How many times as fast as real time the lab runs (1).")
    private double speed = 1;

    @Option(
            names = "--aibo-port",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "TCP port of the Aibo (54000, or a free one).")
    private int aiboPort = LabPorts.AIBO;

    @Option(
            names = "--pioneer-port",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "TCP port of the Pioneer (8101, or a free one).")
    private int pioneerPort = LabPorts.PIONEER;

    @Option(
            names = "--hemisson-port",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "TCP port of the Hemisson (a free one).")
    private int hemissonPort;

    @Option(
            names = "--pioneer-model",
            scope = ScopeType.INHERIT,
            paramLabel = "MODEL",
            completionCandidates = PioneerModels.class,
            description = {
                "Which Pioneer stands in the lab (p3dx-sh): ${COMPLETION-CANDIDATES}.",
                "With extras: p3dx-sh+gripper+gyro+charger+compass+laser+bumpers."
            })
    private String pioneerModel = PioneerRobot.STANDARD_MODEL;

    @Option(
            names = "--hemisson-model",
            scope = ScopeType.INHERIT,
            paramLabel = "MODEL",
            description = {
                "Which Hemisson stands in the lab (kteam): kteam or roadnarrows, and what is different about it:",
                "modules +camera +ultrasonic +speech +lcd +io, +switches=1110 (running mode), +overrun (a third waiting"
                        + " character stops its receiver), +paced, +ambient=60 (0 sun to 255 dark), +mismatch=5 (right wheel"
                        + " faster, percent)."
            })
    private String hemissonModel = KTEAM;

    @Option(
            names = "--ros-port",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "TCP port of the ROS robot's rosbridge server (9090, or a free one).")
    private int rosPort = LabPorts.ROS;

    @Option(
            names = "--ros",
            scope = ScopeType.INHERIT,
            paramLabel = "MODEL",
            arity = "0..1",
            parameterConsumer = RosModelConsumer.class,
            description = {
                "Puts a ROS robot into the lab, a TurtleBot3 behind a rosbridge server: 1 (ROS 1, the default) or 2 (ROS 2), and",
                "what is different about it: +stamped (TwistStamped commands), +timeout=1.0 or +timeout=none (when it"
                        + " stops without commands), +unblocked, +nonavigation, +namespace=NAME, +robots=2, +camera, +auth=SECRET, +server=NAME."
            })
    private @Nullable String rosModel;

    @Option(
            names = "--mavlink-port",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description =
                    "TCP port of the first MAVLink vehicle (5760, or a free one); each further one listens 10 above.")
    private int mavlinkPort = LabPorts.MAVLINK;

    @Option(
            names = "--mavlink",
            scope = ScopeType.INHERIT,
            paramLabel = "MODELS",
            arity = "0..1",
            parameterConsumer = MavlinkModelConsumer.class,
            description = {
                "Puts MAVLink vehicles into the lab, with commas between them: rover (ArduRover, the default), boat or copter",
                "(ArduCopter), and what is different about each: +ready (it can be armed at once, not after 44 s), +v1 (MAVLink 1"
                        + " alone), +udp=14550 (also sends to a ground station at this port)."
            })
    private @Nullable String mavlinkModels;

    @Option(
            names = "--pioneers",
            scope = ScopeType.INHERIT,
            paramLabel = "N",
            description = "How many Pioneers stand in the lab, 1 to " + LabOptions.MOST_PIONEERS
                    + " (1); the others are sim:pioneer2, sim:pioneer3 … More than nine stand in a larger hall.")
    private int pioneers = 1;

    /** Returns whether a lab other than the default one is chosen. */
    boolean isGiven() {
        boolean ports = aiboPort != LabPorts.AIBO || pioneerPort != LabPorts.PIONEER || hemissonPort != 0;
        boolean model = !pioneerModel.equalsIgnoreCase(PioneerRobot.STANDARD_MODEL);
        boolean hemisson = !hemissonModel.equalsIgnoreCase(KTEAM);
        boolean ros = rosModel != null || rosPort != LabPorts.ROS;
        boolean mavlink = mavlinkModels != null || mavlinkPort != LabPorts.MAVLINK;
        return ros
                || mavlink
                || exact
                || seed != 1
                || world != null
                || speed != 1
                || ports
                || model
                || hemisson
                || pioneers != 1;
    }

    /** Returns the options with which a lab of this choice is opened. */
    LabOptions options() throws IOException {
        RosOptions ros = rosModel == null ? null : model("--ros", rosModel, RosOptions::parse);
        MavlinkOptions mavlink =
                mavlinkModels == null ? null : model("--mavlink", mavlinkModels, MavlinkOptions::parse);
        int others = (ros == null ? 0 : ros.robots())
                + (mavlink == null ? 0 : mavlink.vehicles().size());
        Room room = world == null ? LabOptions.roomFor(pioneers() + others) : Room.load(world);
        LabPorts ports =
                new LabPorts(port(aiboPort), port(pioneerPort), port(hemissonPort), port(rosPort), port(mavlinkPort));
        String pioneer = model("--pioneer-model", pioneerModel, PioneerRobot::modelNamed);
        HemissonOptions hemisson = model("--hemisson-model", hemissonModel, HemissonOptions::parse);
        return new LabOptions(room, exact, seed, ports, !exact, pioneer, hemisson, pioneers(), ros, mavlink);
    }

    /** Returns its speed, after a check. */
    double speed() {
        if (!(speed >= SLOWEST && speed <= FASTEST)) {
            throw new UsageException("--speed " + speed + ": outside " + SLOWEST + " … " + FASTEST);
        }
        return speed;
    }

    /** Reports which default ports were in use, so that no robot is expected there. */
    void reportTakenPorts(Map<String, String> addresses) {
        reportIfTaken("aibo", aiboPort, addresses);
        reportIfTaken("pioneer", pioneerPort, addresses);
        if (rosModel != null) {
            reportIfTaken("ros", rosPort, addresses);
        }
        if (mavlinkModels != null) {
            reportIfTaken("mavlink", mavlinkPort, addresses);
        }
    }

    private int pioneers() {
        if (pioneers < 1 || pioneers > LabOptions.MOST_PIONEERS) {
            throw new UsageException("--pioneers " + pioneers + ": outside 1 … " + LabOptions.MOST_PIONEERS);
        }
        return pioneers;
    }

    /** Reads the model of a robot, whose parser says what would be right. */
    private static <T> T model(String option, String chosen, Function<String, T> parser) {
        try {
            return parser.apply(chosen);
        } catch (IllegalArgumentException e) {
            throw new UsageException(option + " " + chosen + ": " + e.getMessage());
        }
    }

    private static void reportIfTaken(String robot, int wanted, Map<String, String> addresses) {
        String address = addresses.getOrDefault(robot, "");
        if (wanted != 0 && !address.matches(".*:" + wanted + "(/.*)?")) {
            System.err.println("majic: port " + wanted + " is taken; the lab's " + robot + " listens at " + address);
        }
    }

    private static int port(int port) {
        if (port < 0 || port > 65_535) {
            throw new UsageException("port " + port + ": outside 0 … 65535");
        }
        return port;
    }

    /** Takes the next word only if it is a model, so that a file or a command can follow {@code --ros}. */
    private static final class RosModelConsumer implements IParameterConsumer {
        private static final String STANDARD = "1";

        @Override
        public void consumeParameters(Stack<String> words, ArgSpec option, CommandSpec command) {
            boolean isModel = !words.isEmpty() && words.peek().matches("\\d.*");
            option.setValue(isModel ? words.pop() : STANDARD);
        }
    }

    /** Takes the next word only if it names vehicles, so that a file or a command can follow {@code --mavlink}. */
    private static final class MavlinkModelConsumer implements IParameterConsumer {
        private static final String STANDARD = "rover";
        private static final String MODELS = "(?i)(rover|boat|copter)([+,].*)?";

        @Override
        public void consumeParameters(Stack<String> words, ArgSpec option, CommandSpec command) {
            boolean areModels = !words.isEmpty() && words.peek().matches(MODELS);
            option.setValue(areModels ? words.pop() : STANDARD);
        }
    }

    /** Lists the Pioneer models for the help. */
    private static final class PioneerModels implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return PioneerRobot.models().iterator();
        }
    }
}
