package majic.stop;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jna.Function;
import com.sun.jna.Memory;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import majic.Majic;
import majic.bot.Pose;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that a robot is stopped when the program that embeds it ends or is suspended during a motion. */
@Tag("jdk")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has neither signals nor pseudo-terminals")
class ShutdownTest {
    /** On a busy computer a simulated robot may answer too late while it is being connected. */
    private static final int ATTEMPTS = 5;

    /** The lowest exit status of a program that a signal ended. */
    private static final int ENDED_BY_A_SIGNAL = 128;

    private static final String PIONEER_STOP = "\u00FA\u00FB\u0003\u001D\0\u001D";

    enum Robot {
        PIONEER("pioneer", PIONEER_STOP),
        PIONEER_ON_A_PORT("pioneer", PIONEER_STOP),
        AIBO("aibo", "stop walk, stop turn,"),
        HEMISSON_ON_A_PORT("hemisson", "D,0,0\r"),
        PLUGIN("cart", "drive 0 0\n");

        private final String type;
        private final String stop;

        Robot(String type, String stop) {
            this.type = type;
            this.stop = stop;
        }

        RecordingRelay line(SimulatedLab lab) throws IOException {
            if (this == PLUGIN) {
                return RecordingRelay.mute();
            }
            String address = lab.address(type).orElseThrow().toString();
            int port = Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
            return name().endsWith("PORT") ? RecordingRelay.serial(port) : RecordingRelay.tcp(port);
        }
    }

    enum End {
        INT,
        TERM,
        HUP,
        EXIT
    }

    static Stream<Arguments> robotsAndEnds() {
        return Stream.of(Robot.values())
                .flatMap(robot -> Stream.of(End.values()).map(end -> Arguments.of(robot, end)));
    }

    @ParameterizedTest
    @MethodSource("robotsAndEnds")
    void theRobotIsStoppedHoweverTheProgramEnds(Robot robot, End end) throws Exception {
        repeatUntilConnected(() -> isStoppedWhenTheProgramEnds(robot, end));
    }

    private static void repeatUntilConnected(Callable<Boolean> test) throws Exception {
        boolean connected = false;
        for (int attempt = 0; !connected && attempt < ATTEMPTS; attempt++) {
            connected = test.call();
        }

        assertThat(connected).isTrue();
    }

    /** Returns false if the program could not connect the robot. */
    private static boolean isStoppedWhenTheProgramEnds(Robot robot, End end) throws Exception {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
                RecordingRelay line = robot.line(lab)) {
            Process program = start(EndedProgram.class, Map.of(), robot.type + ":" + line.address());
            try {
                if (awaitLine(program, "moving", EndedProgram.NOT_CONNECTED).startsWith(EndedProgram.NOT_CONNECTED)) {
                    return false;
                }
                int before = line.sent().length();

                end(program, end);

                program.waitFor();
                line.sent().await(robot.stop, before);
                awaitStationary(lab, robot.type);
                return true;
            } finally {
                program.destroyForcibly();
            }
        }
    }

    @Test
    void aDogDoesNotWalkOnWhenTheProgramStoodStillAndGoesOn() throws Exception {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
                RecordingRelay line = Robot.AIBO.line(lab)) {
            Process program = start(EndedProgram.class, Map.of(), "aibo:" + line.address(), "80");
            try {
                awaitLine(program, "moving");
                line.sent().await("robot.walk(", 0);
                signal(program, "STOP");
                lab.time().sleep(3);
                int before = line.sent().length();

                signal(program, "CONT");

                awaitLine(program, "failed: ");
                line.sent().await("stop walk, stop turn,", before);
                lab.time().sleep(2);
                assertThat(line.sent().since(before)).doesNotContain("robot.walk(");
                awaitStationary(lab, "aibo");
            } finally {
                program.destroyForcibly();
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"INT", "TERM", "HUP"})
    void theProgramStopsARobotAtASerialPortWhenASignalEndsIt(End end, @TempDir Path folder) throws Exception {
        repeatUntilConnected(() -> isStoppedWhenTheScriptEnds(Robot.PIONEER_ON_A_PORT, end, folder));
    }

    @Test
    void aScriptEndsWithItsTerminalThoughASerialPortIsOpen(@TempDir Path folder) throws Exception {
        repeatUntilConnected(() -> isStoppedWhenTheScriptEnds(Robot.HEMISSON_ON_A_PORT, End.HUP, folder));
    }

    /** Returns false if the script ended before the signal, since it could not connect the robot or lost it. */
    private static boolean isStoppedWhenTheScriptEnds(Robot robot, End end, Path folder) throws Exception {
        Path script = Files.writeString(folder.resolve("far.majic"), "1 move 1000");
        Map<String, String> home = Map.of("MAJIC_HOME", folder.toString());
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
                RecordingRelay line = robot.line(lab)) {
            Process program =
                    start(Majic.class, home, "run", "--add", robot.type + ":" + line.address(), script.toString());
            try {
                if (!awaitMoving(lab, robot.type, program)) {
                    return false;
                }
                int before = line.sent().length();

                end(program, end);

                if (program.waitFor() < ENDED_BY_A_SIGNAL) {
                    return false;
                }
                line.sent().await(robot.stop, before);
                awaitStationary(lab, robot.type);
                return true;
            } finally {
                program.destroyForcibly();
            }
        }
    }

    /** Returns false if the program ends first. */
    private static boolean awaitMoving(SimulatedLab lab, String type, Process program) throws InterruptedException {
        Pose start = lab.truePoses().get(type);
        while (start.equals(lab.truePoses().get(type))) {
            if (!program.isAlive()) {
                return false;
            }
            lab.time().sleep(0.05);
        }
        return true;
    }

    private static String awaitLine(Process program, String... starts) throws IOException {
        BufferedReader printed = program.inputReader();
        List<String> lines = new ArrayList<>();
        String line = "";
        while (Stream.of(starts).noneMatch(line::startsWith)) {
            lines.add(line);
            line = printed.readLine();
            assertThat(line).as("printed before: %s", lines).isNotNull();
        }
        return line;
    }

    private static void awaitStationary(SimulatedLab lab, String type) throws InterruptedException {
        Pose before = null;
        for (Pose now = lab.truePoses().get(type); now != null && !now.equals(before); ) {
            before = now;
            lab.time().sleep(0.2);
            now = lab.truePoses().get(type);
        }
    }

    private static void end(Process program, End end) throws Exception {
        if (end == End.EXIT) {
            program.getOutputStream().write('\n');
            program.getOutputStream().flush();
        } else {
            signal(program, end.name());
        }
    }

    private static void signal(Process program, String name) throws Exception {
        new ProcessBuilder("kill", "-" + name, String.valueOf(program.pid()))
                .start()
                .waitFor();
    }

    private static Process start(Class<?> program, Map<String, String> environment, String... args) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                program.getName()));
        command.addAll(List.of(args));
        ProcessBuilder process = new ProcessBuilder(command).redirectErrorStream(true);
        process.environment().putAll(environment);
        UsualSignals signals = new UsualSignals();
        try {
            return process.start();
        } finally {
            signals.restore();
        }
    }

    /**
     * Starts a new process with the default actions of its signals. A process inherits the ignored signals, and a shell
     * script starts background processes, such as a test run, with SIGINT ignored.
     */
    private static final class UsualSignals {
        private static final Function SIGACTION =
                NativeLibrary.getInstance(Platform.C_LIBRARY_NAME).getFunction("sigaction");
        private static final List<Integer> SIGHUP_AND_SIGINT = List.of(1, 2);

        private final Map<Integer, Memory> before = new HashMap<>();

        UsualSignals() {
            Memory usual = new Memory(512);
            usual.clear();
            for (int signal : SIGHUP_AND_SIGINT) {
                before.put(signal, new Memory(512));
                SIGACTION.invokeInt(new Object[] {signal, usual, before.get(signal)});
            }
        }

        void restore() {
            before.forEach((signal, action) -> SIGACTION.invokeInt(new Object[] {signal, action, null}));
        }
    }
}
