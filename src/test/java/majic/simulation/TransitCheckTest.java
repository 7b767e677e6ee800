package majic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import majic.link.Traffic;
import majicsim.net.LineCount;
import org.junit.jupiter.api.Test;

/** Tests when no byte is in transit between the drivers and the robots. */
class TransitCheckTest {
    private static final String DOG = "127.0.0.1:54000";
    private static final String PIONEER = "127.0.0.1:8101";
    private static final String LOCAL = "127.0.0.1:40312";

    private static boolean isQuiet(List<Traffic> links, List<LineCount> lines) {
        return new TransitCheck(() -> links, () -> lines, Set.of(DOG, PIONEER)).getAsBoolean();
    }

    @Test
    void oneLocalPortMayServeConnectionsWithTwoRobots() {
        List<Traffic> links = List.of(new Traffic(LOCAL, DOG, 5, 7, true), new Traffic(LOCAL, PIONEER, 3, 9, true));
        List<LineCount> lines =
                List.of(new LineCount(DOG, LOCAL, 5, 7, true, false), new LineCount(PIONEER, LOCAL, 3, 9, true, false));

        assertThat(isQuiet(links, lines)).isTrue();
    }

    @Test
    void aByteUnderWayEitherWayIsSeen() {
        List<Traffic> links = List.of(new Traffic(LOCAL, DOG, 5, 7, true));

        assertThat(isQuiet(links, List.of(new LineCount(DOG, LOCAL, 4, 7, true, false))))
                .isFalse();
        assertThat(isQuiet(links, List.of(new LineCount(DOG, LOCAL, 5, 8, true, false))))
                .isFalse();
    }
}
