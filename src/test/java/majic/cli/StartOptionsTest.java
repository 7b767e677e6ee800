package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class StartOptionsTest {
    @Test
    void theRobotsOfTheLabAreAddedInItsOrder() {
        assertThat(StartOptions.labLines(List.of("aibo", "pioneer"), 20))
                .containsExactly("add sim:aibo as 1", "add sim:pioneer as 2");
    }

    @Test
    void ofALargeLabAsManyRobotsAreAddedAsATeamHasNumbers() {
        assertThat(StartOptions.labLines(Collections.nCopies(502, "pioneer"), 200))
                .hasSize(200);
    }
}
