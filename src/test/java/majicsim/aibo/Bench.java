package majicsim.aibo;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majicsim.net.Line;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;

/** A simulated dog alone in a room, stepped by hand, with clients that remember what they were sent. */
final class Bench {
    private static final String EMPTY =
            "2D-Map\nLineMinPos: -20000 -20000\nLineMaxPos: 20000 20000\nNumLines: 0\nLINES\n";
    private static final double STEP_SEC = 0.004;

    private final AiboRobot dog;
    private final World world;
    private double nowMs;

    private Bench(String map, Noise noise) {
        try {
            world = new World(Room.parse(new StringReader(map), "the test's room"));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the room", e);
        }
        dog = new AiboRobot(world, new Pose(0, 0, 0), noise);
    }

    static Bench exact() {
        return new Bench(EMPTY, Noise.exact());
    }

    /** In a room of its own. */
    static Bench in(String map) {
        return new Bench(map, Noise.exact());
    }

    static Bench noisy(long seed) {
        return new Bench(EMPTY, Noise.seeded(seed));
    }

    AiboRobot dog() {
        return dog;
    }

    World world() {
        return world;
    }

    /** Lets lab time pass. */
    void run(double ms) {
        for (double end = nowMs + ms; nowMs < end - 1e-6; nowMs += STEP_SEC * 1000) {
            world.step(STEP_SEC);
            dog.step(STEP_SEC);
        }
    }

    /** A new client, past its banner. */
    Client client() {
        Client client = new Client();
        dog.connected(client);
        run(64);
        client.take();
        return client;
    }

    /** One client. */
    final class Client implements Line {
        private final ByteArrayOutputStream received = new ByteArrayOutputStream();
        private boolean open = true;

        void say(String text) {
            dog.received(this, text.getBytes(StandardCharsets.ISO_8859_1));
        }

        /** Sends it, waits, and takes what came. */
        List<String> ask(String text, double waitMs) {
            say(text);
            run(waitMs);
            return take();
        }

        List<String> ask(String text) {
            return ask(text, 228);
        }

        /** The lines that came since the last call, without their time stamps. */
        List<String> take() {
            String text = raw();
            List<String> lines = new ArrayList<>();
            for (String line : text.split("\n")) {
                if (!line.isEmpty()) {
                    lines.add(line.replaceFirst("^\\[\\d{8,}:", "["));
                }
            }
            return lines;
        }

        /** All that came since the last call, as it came. */
        String raw() {
            String text = received.toString(StandardCharsets.ISO_8859_1);
            received.reset();
            return text;
        }

        void hangUp() {
            open = false;
            dog.disconnected(this);
        }

        @Override
        public String peer() {
            return "127.0.0.1:40000";
        }

        @Override
        public void send(byte[] message) {
            received.writeBytes(message);
        }

        /** The bytes that a test has not taken. */
        @Override
        public int unsent() {
            return received.size();
        }

        @Override
        public void close() {
            open = false;
        }

        @Override
        public boolean isOpen() {
            return open;
        }
    }
}
