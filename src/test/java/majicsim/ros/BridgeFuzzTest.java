package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majicsim.net.Line;
import majicsim.ros.options.RosOptions;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;

/**
 * Whatever bytes come from a client: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class BridgeFuzzTest {
    private static final String QUESTION = "{\"op\":\"call_service\",\"id\":\"sane\",\"service\":\"/rosapi/get_time\"}";
    private static final double STEP_S = 0.004;

    @FuzzTest
    void theBridgeServesOtherClientsAfterAnyBytes(byte[] wire) {
        assertServesAfter("1", wire);
    }

    @FuzzTest
    void theBridgeServesOtherClientsAfterAnyText(byte[] text) {
        assertServesAfter("1", RawWebSocket.frame(RawWebSocket.TEXT, true, text));
        assertServesAfter("2", RawWebSocket.frame(RawWebSocket.TEXT, true, text));
    }

    @FuzzTest
    void theSameIsAnsweredHoweverTheBytesAreCut(byte[] text) {
        byte[] wire = RawWebSocket.frame(RawWebSocket.TEXT, true, text);
        RosRobot whole = robot("2");
        RosRobot cut = robot("2");
        Answers wholeAnswers = connected(whole);
        Answers cutAnswers = connected(cut);

        whole.received(wholeAnswers, wire);
        for (byte one : wire) {
            cut.received(cutAnswers, new byte[] {one});
        }

        assertThat(cutAnswers.texts).isEqualTo(wholeAnswers.texts);
    }

    private static void assertServesAfter(String model, byte[] wire) {
        RosRobot robot = robot(model);
        Answers noisy = connected(robot);
        for (int at = 0; at < wire.length; at += 7) {
            robot.received(noisy, Arrays.copyOfRange(wire, at, Math.min(wire.length, at + 7)));
            robot.step(STEP_S);
        }
        Answers sane = connected(robot);
        robot.received(sane, RawWebSocket.frame(RawWebSocket.TEXT, true, QUESTION.getBytes(StandardCharsets.UTF_8)));
        assertThat(sane.texts).last().asString().contains("\"time\"");
        robot.disconnected(noisy);
        robot.disconnected(sane);
        robot.step(STEP_S);
    }

    private static RosRobot robot(String model) {
        World world = new World(Room.standard());
        return new RosRobot(world, List.of(new Pose(0, 0, 0)), Noise.exact(), RosOptions.parse(model));
    }

    private static Answers connected(RosRobot robot) {
        Answers answers = new Answers();
        robot.connected(answers);
        robot.received(answers, RawWebSocket.handshake("/"));
        return answers;
    }

    /** A line that keeps what is sent. */
    private static final class Answers implements Line {
        private final List<String> texts = new ArrayList<>();
        private boolean isOpen = true;

        @Override
        public String peer() {
            return "127.0.0.1:1";
        }

        @Override
        public void send(byte[] message) {
            texts.add(new String(message, StandardCharsets.ISO_8859_1));
        }

        @Override
        public void close() {
            isOpen = false;
        }

        @Override
        public boolean isOpen() {
            return isOpen;
        }
    }
}
