package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class CompletedLineTest {
    @Test
    void theOnlyCandidateIsTakenWithABlankBehind() {
        assertThat(CompletedLine.complete("1 mo", 2, 4, List.of("move"))).isEqualTo(new CompletedLine("1 move ", 7));
    }

    @Test
    void severalAreCompletedAsFarAsTheyAgree() {
        List<String> all = List.of("headPan", "headTilt");
        assertThat(CompletedLine.complete("1 get h", 6, 7, all)).isEqualTo(new CompletedLine("1 get head", 10));
    }

    @Test
    void withoutCandidatesNothingChanges() {
        assertThat(CompletedLine.complete("1 xyz", 2, 5, List.of())).isEqualTo(new CompletedLine("1 xyz", 5));
    }

    @Test
    void theRestOfTheLineIsKept() {
        assertThat(CompletedLine.complete("1 mo 500", 2, 4, List.of("move")))
                .isEqualTo(new CompletedLine("1 move 500", 6));
    }

    @Test
    void anAddressGoesOnBehindItsColon() {
        assertThat(CompletedLine.complete("add pio", 4, 7, List.of("pioneer:")).text())
                .isEqualTo("add pioneer:");
    }
}
