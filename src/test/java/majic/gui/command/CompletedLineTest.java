package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class CompletedLineTest {
    @Test
    void theOnlyCandidateIsTakenWithABlankBehind() {
        assertThat(CompletedLine.complete("1 mo", 4, List.of("move")))
                .isEqualTo(new CompletedLine("1 move ", 7, List.of()));
    }

    @Test
    void severalAreCompletedAsFarAsTheyAgreeAndShown() {
        List<String> all = List.of("headPan", "headTilt");
        assertThat(CompletedLine.complete("1 get h", 7, all)).isEqualTo(new CompletedLine("1 get head", 10, all));
    }

    @Test
    void withoutCandidatesNothingChanges() {
        assertThat(CompletedLine.complete("1 xyz", 5, List.of())).isEqualTo(new CompletedLine("1 xyz", 5, List.of()));
    }

    @Test
    void theRestOfTheLineIsKept() {
        CompletedLine done = CompletedLine.complete("1 mo 500", 4, List.of("move"));
        assertThat(done.text()).isEqualTo("1 move 500");
    }

    @Test
    void theNextOfAListIsAWordOfItsOwn() {
        assertThat(CompletedLine.complete("1 get x,head", 12, List.of("heading"))
                        .text())
                .isEqualTo("1 get x,heading ");
    }
}
