package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The full captures of the real kernel against the simulator, from the folder that {@code -Dmajic.captures} names. */
class CaptureReplayTest {
    /** What is not sent, and why: the rest of the captures must agree. */
    private static final Map<String, String> OUT_OF_SUBSET = Map.ofEntries(
            Map.entry("l1: every(100) headPan.val,", "when in the swing a sample falls depends on the cycle"),
            Map.entry("stop l1;", "belongs to the former"),
            Map.entry(
                    "headPan.val->speedmax = 10;",
                    "the real kernel ends a plain assignment before a slow joint is there"),
            Map.entry("q: headPan = 10;", "belongs to the former"));

    /** The measured values of joints that move, or have just moved, depend on the hardware: so far they may be off. */
    private static final double JOINT_TOLERANCE_DEG = 45;

    @ParameterizedTest
    @ValueSource(strings = {"A", "B", "C", "F"})
    void theLanguageAnswersAsTheRealKernel(String file) throws IOException {
        for (Transcript session : captured(file)) {
            Replay replay = Replay.of(session, OUT_OF_SUBSET::containsKey);

            assertThat(replay.received()).containsExactlyElementsOf(replay.expected());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"E", "H"})
    void theDogAnswersAsTheRealKernelUpToItsHardware(String file) throws IOException {
        for (Transcript session : captured(file)) {
            Replay replay = Replay.of(session, OUT_OF_SUBSET::containsKey);

            assertThat(replay.received())
                    .usingElementComparator((a, b) -> isSame(a, b) ? 0 : 1)
                    .containsExactlyElementsOf(replay.expected());
        }
    }

    @Test
    void theFramingOfTheRealSplitterIsOurs() throws IOException {
        Bench bench = Bench.exact();
        Bench.Client client = bench.client();
        for (String line : capture("K-framing")) {
            FramingLine framing = FramingLine.parse(line);
            if (framing.isCut()) {
                return;
            }
            String answer = String.join("\n", client.ask(framing.sent()));
            assertThat(answer).as(framing.sent()).isEqualTo(framing.received());
        }
    }

    private static boolean isSame(String a, String b) {
        String[] left = a.split(" ", 2);
        String[] right = b.split(" ", 2);
        boolean numbers = left.length == 2
                && right.length == 2
                && left[0].equals(right[0])
                && left[1].matches("-?\\d+\\.\\d{6}")
                && right[1].matches("-?\\d+\\.\\d{6}");
        return a.equals(b)
                || (numbers
                        && Math.abs(Double.parseDouble(left[1]) - Double.parseDouble(right[1])) < JOINT_TOLERANCE_DEG);
    }

    private static List<Transcript> captured(String file) throws IOException {
        List<Transcript> sessions = Transcript.parse(capture(file));
        assertThat(sessions).isNotEmpty();
        return sessions;
    }

    private static List<String> capture(String file) throws IOException {
        String folder = System.getProperty("majic.captures", "");
        assumeTrue(!folder.isEmpty(), "no captures were named");
        return Files.readAllLines(Path.of(folder, "urbi", file + ".txt"));
    }
}
