package majic.aibo;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import majic.StandingRobot;

/**
 * Simulates an Aibo for benchmarks: sends its greeting, answers every tagged command with the same number, and every
 * repeated command with one reading a second.
 */
final class StandingDog {
    static final String INTRODUCTION = """
            [00005152:start] *** URBI Kernel version 1.0 rev. 153
            [00005152:ident] *** ID: U94665654017648
            """;

    private final Socket client;
    private final StandingRobot robot;

    private StandingDog(Socket client, StandingRobot robot) {
        this.client = client;
        this.robot = robot;
    }

    static StandingRobot open() throws IOException {
        return new StandingRobot("dog", (client, robot) -> new StandingDog(client, robot).talk());
    }

    private void talk() throws IOException {
        BufferedReader in =
                new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
        write(INTRODUCTION);
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            answer(line);
        }
    }

    private void answer(String line) throws IOException {
        int colon = line.indexOf(':');
        int reading = line.indexOf("{ ") + 2;
        if (line.contains("stop walk")) {
            return;
        }
        if (line.contains("every")) {
            String tag = line.substring(reading, line.indexOf(':', reading));
            robot.every(1000, () -> say(tag, "15.000000"));
        } else if (line.contains("ping")) {
            say(line.substring(0, colon), "*** pong time=5918");
        } else if (colon > 0) {
            say(line.substring(0, colon), "15.000000");
        }
    }

    private void say(String tag, String body) throws IOException {
        write("[00005917:" + tag + "] " + body + "\n");
    }

    private synchronized void write(String message) throws IOException {
        client.getOutputStream().write(message.getBytes(StandardCharsets.ISO_8859_1));
    }
}
