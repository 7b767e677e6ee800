package majicsim;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import majicsim.aibo.AiboRobot;
import majicsim.hemisson.HemissonRobot;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.mavlink.MavlinkVehicle;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.net.Firmware;
import majicsim.net.FirmwareClock;
import majicsim.net.LabTime;
import majicsim.net.Line;
import majicsim.pioneer.PioneerRobot;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.ros.RawWebSocket;
import majicsim.ros.RosRobot;
import majicsim.ros.options.RosOptions;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests that a robot whose steps are left out while it rests sends the same bytes at the same times as one that takes
 * each step.
 */
class RestingRobotsTest {
    private static final long STEP_NANOS = 4_000_000;
    private static final int STEPS = 2500;
    private static final Pose START = new Pose(0, 0, 0);

    @Test
    void aPioneerReportsTheSame() {
        Map<Integer, byte[]> commands = Map.of(
                3, Hex.concat(command(0), command(1), command(2)),
                9, Hex.concat(command(1), command(58, 1)),
                207, Hex.concat(command(4, 1), command(8, 600)),
                903, command(13, 30),
                1200, command(0));
        Maker pioneer = (world, noise) -> new PioneerRobot(world, START, noise, "p3dx-sh+gyro+bumpers");

        assertThat(rested(pioneer, commands)).hasSizeGreaterThan(50).isEqualTo(stepped(pioneer, commands));
    }

    @Test
    void aHemissonAnswersTheSame() {
        Map<Integer, byte[]> commands = Map.of(
                3, text("N\r"),
                400, text("D,3,-3\r"),
                401, text("N\r"),
                1303, text("D,0,0\r"),
                1900, text("N\rO\r"));
        Maker hemisson = (world, noise) ->
                new HemissonRobot(world, START, noise, HemissonOptions.parse("kteam+ultrasonic+paced"));

        assertThat(rested(hemisson, commands)).hasSizeGreaterThan(4).isEqualTo(stepped(hemisson, commands));
    }

    @Test
    void anAiboRepliesTheSame() {
        Map<Integer, byte[]> commands = Map.of(
                3, text("every (200ms) { headPan.val; accelX.val; },"),
                101, text("motors on; headPan.val = 30 time:900;"),
                803, text("robot.walk(1000);"),
                1702, text("distance.val; time();"));
        Maker aibo = (world, noise) -> new AiboRobot(world, START, noise);

        assertThat(rested(aibo, commands)).hasSizeGreaterThan(40).isEqualTo(stepped(aibo, commands));
    }

    @Test
    void aRosRobotPublishesTheSame() {
        Map<Integer, byte[]> commands = Map.of(
                3, RawWebSocket.handshake("/"),
                5, json("{'op':'subscribe','topic':'/odom','throttle_rate':300,'queue_length':1}"),
                6, json("{'op':'subscribe','topic':'/move_base/result'}"),
                300, json("{'op':'publish','topic':'/cmd_vel','msg':{'linear':{'x':0.1},'angular':{'z':0.5}}}"),
                801, json("{'op':'publish','topic':'/move_base_simple/goal','msg':{'pose':{'orientation':{'w':1}}}}"),
                1900, json("{'op':'call_service','service':'/rosapi/get_time'}"));
        Maker ros = (world, noise) -> new RosRobot(world, List.of(START), noise, RosOptions.parse("1"));

        assertThat(rested(ros, commands)).hasSizeGreaterThan(30).isEqualTo(stepped(ros, commands));
    }

    @Test
    void aMavlinkVehicleSendsTheSame() {
        Map<Integer, byte[]> commands = Map.of(
                3, mavlink(511, 30, 70_000),
                400, mavlink(176, 1, 15),
                1001, mavlink(400, 1, 0),
                1402, mavlink(176, 1, 0),
                1603, mavlink(400, 0, 0));
        MavlinkOptions kinds = MavlinkOptions.parse("rover+ready");
        Maker rover = (world, noise) -> new MavlinkVehicle(
                "mavlink", world, START, noise, kinds.vehicles().get(0), 1);

        assertThat(rested(rover, commands)).hasSizeGreaterThan(150).isEqualTo(stepped(rover, commands));
    }

    private static byte[] mavlink(int command, double param1, double param2) {
        Message message = new Message(MessageType.COMMAND_LONG)
                .with("command", command)
                .with("param1", param1)
                .with("param2", param2);
        return new Frame(2, 0, 255, 190, message).toBytes();
    }

    private static byte[] json(String quoted) {
        byte[] text = quoted.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
        return RawWebSocket.frame(RawWebSocket.TEXT, true, text);
    }

    private static List<String> stepped(Maker maker, Map<Integer, byte[]> commands) {
        World world = new World(Room.standard());
        Firmware robot = maker.make(world, Noise.seeded(1));
        return run(world, commands, new Stepping() {
            @Override
            public void step(long nanos) {
                robot.step(STEP_NANOS / 1e9);
            }

            @Override
            public Firmware used() {
                return robot;
            }
        });
    }

    private static List<String> rested(Maker maker, Map<Integer, byte[]> commands) {
        World world = new World(Room.standard());
        Firmware robot = maker.make(world, Noise.seeded(1));
        LabTime time = new LabTime();
        FirmwareClock clock = new FirmwareClock(robot, time);
        return run(world, commands, new Stepping() {
            @Override
            public void step(long nanos) {
                time.step(STEP_NANOS);
            }

            @Override
            public Firmware used() {
                clock.wake();
                return robot;
            }
        });
    }

    private static List<String> run(World world, Map<Integer, byte[]> commands, Stepping robot) {
        Recorder line = new Recorder();
        robot.used().connected(line);
        for (int step = 1; step <= STEPS; step++) {
            line.step = step;
            world.step(STEP_NANOS / 1e9);
            robot.step(step * STEP_NANOS);
            byte[] command = commands.get(step);
            if (command != null) {
                robot.used().received(line, command);
            }
        }
        return line.sent;
    }

    private static byte[] command(int id) {
        return new PacketWriter(id).toBytes();
    }

    private static byte[] command(int id, int value) {
        return new PacketWriter(id).uint8(0x3B).uint16(value).toBytes();
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    private interface Maker {
        Firmware make(World world, Noise noise);
    }

    private interface Stepping {
        void step(long nanos);

        Firmware used();
    }

    /** Keeps what is sent, with the number of the step. */
    private static final class Recorder implements Line {
        private final List<String> sent = new ArrayList<>();
        private int step;

        @Override
        public String peer() {
            return "127.0.0.1:1";
        }

        @Override
        public void send(byte[] message) {
            sent.add(step + ": " + HexFormat.of().formatHex(message));
        }

        @Override
        public void close() {}

        @Override
        public boolean isOpen() {
            return true;
        }
    }
}
