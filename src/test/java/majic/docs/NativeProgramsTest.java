package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.inlab.acts.ActLabs;
import majic.inlab.acts.LineInLab;
import majic.tool.Tool;
import majicsim.net.LineCount;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests the programs without MAJIC that {@code docs/results.md} compares with those with MAJIC: those for the Aibo and
 * the Hemisson with the simulated robots, those with ARIA by a compiler against its signatures.
 */
class NativeProgramsTest {
    private static final Path PROGRAMS = Path.of("examples", "native");
    private static final double LONGEST_S = 600;
    private static final double STEP_S = 0.02;
    private static final long LOOK_AGAIN_NANOS = 100_000;

    @Test
    void theAiboWandersByItsScriptAndTurnsAtTheWall() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "aibo", new Pose(3000, 0, 0));
            List<String> answers = runOnTheAibo(rig, "WanderDog.u");

            assertThat(answers).noneMatch(line -> line.contains("!!!")).contains("the script has ended");
            assertThat(rig.truePose("aibo").distanceMm(new Pose(3000, 0, 0))).isGreaterThan(100);
            assertThat(ActLabs.bumps(rig)).containsEntry("aibo", 0);
        }
    }

    @Test
    void theAiboWalksHalfAMetre() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            Pose start = rig.truePose("aibo");
            runOnTheAibo(rig, "Walk.u");
            assertThat(rig.truePose("aibo").distanceMm(start)).isBetween(490.0, 510.0);
        }
    }

    /**
     * Sends a script to the Aibo and lets lab time pass until it has ended; returns what the Aibo sent, without tags.
     */
    private static List<String> runOnTheAibo(LabRig rig, String script) throws IOException, InterruptedException {
        String address = rig.lab().simulators().addresses().get("aibo");
        int port = Integer.parseInt(address.substring(address.indexOf(':') + 1));
        List<String> answers = new ArrayList<>();
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            String text = Files.readString(PROGRAMS.resolve(script)) + "echo \"the script has ended\";\n";
            socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
            InputStream input = socket.getInputStream();
            StringBuilder received = new StringBuilder();
            for (double s = 0; s < LONGEST_S && received.indexOf("the script has ended") < 0; s++) {
                rig.lab().time().sleep(1);
                received.append(new String(input.readNBytes(input.available()), StandardCharsets.ISO_8859_1));
            }
            received.toString().lines().forEach(line -> answers.add(line.replaceFirst("^\\[\\S+] (\\*\\*\\* )?", "")));
        }
        return answers;
    }

    @Test
    void theHemissonFollowsTheLineToTheObstacle(@TempDir Path folder) throws Exception {
        Tool.require("g++");
        Path program = folder.resolve("follower");
        assertThat(compiled("LineFollower.cpp", "-o", program.toString())).isEmpty();
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "hemisson", LineInLab.BESIDE_IT);
            ActLabs.place(rig, "pioneer", LineInLab.OBSTACLE);
            String port = rig.lab().simulators().addresses().get("hemisson-pty");
            Process following = new ProcessBuilder(program.toString(), port).start();
            try {
                for (double s = 0; s < LONGEST_S && following.isAlive(); s += STEP_S) {
                    rig.lab().time().sleep(STEP_S);
                    awaitCommands(rig, port, following);
                    assertThat(LineInLab.offTheLineMm(rig)).isLessThan(LineInLab.WIDEST_MM);
                }
                assertThat(following.waitFor()).isZero();
            } finally {
                following.destroy();
            }
            LineInLab.assertIsAtTheObstacle(rig);
        }
    }

    /**
     * Waits until the program has asked for readings and set the speeds twice, so that the speeds are by the readings
     * of now. Leaves the processor to the program and the robot meanwhile, which have 5 s of real time for an answer.
     */
    private static void awaitCommands(LabRig rig, String port, Process program) {
        long enough = consumed(rig, port) + 2 * "N?D,2,4?".length();
        while (consumed(rig, port) < enough && program.isAlive()) {
            LockSupport.parkNanos(LOOK_AGAIN_NANOS);
        }
    }

    private static long consumed(LabRig rig, String port) {
        return rig.lab().simulators().lines().stream()
                .filter(line -> line.robot().equals(port))
                .mapToLong(LineCount::consumed)
                .sum();
    }

    @ParameterizedTest
    @ValueSource(strings = {"GreatRace.cpp", "Wanderer.cpp", "Actions.cpp", "ToAndFro.cpp", "Wall.cpp", "Spiral.cpp"})
    void theProgramsWithAriaCompile(String program) throws Exception {
        Tool.require("g++");
        assertThat(compiled(program, "-fsyntax-only")).isEmpty();
    }

    private static String compiled(String program, String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("g++", "-std=c++17", "-Wall", "-Wextra", "-Isrc/vendor/cpp"));
        command.addAll(List.of(options));
        command.add(PROGRAMS.resolve(program).toString());
        return Tool.run(command.toArray(String[]::new));
    }
}
