package majic.soak;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The short form of the program {@link Soak}. */
class SoakTest {
    private static final int LINES = 600;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void everyCommandEndsOnceAndEveryRobotObeysAfterwardsHoweverItsConnectionFails(long seed) throws Exception {
        SoakRound.Result result = round(seed);

        assertThat(result.problems()).isEmpty();
        assertThat(result.outcomes()).containsKeys(Outcome.DONE, Outcome.LOST, Outcome.NOT_RUN, Outcome.REFUSED);
        assertThat(result.faults()).containsKeys(FaultScript.Kind.values());
    }

    @Test
    void noThreadAndNoHandleIsLeftOver() throws Exception {
        Resources atFirst = Resources.now();
        round(3);
        Resources before = Resources.settledSince(atFirst);

        round(4);

        assertThat(Resources.settledSince(before).leftOverSince(before)).isEmpty();
    }

    private SoakRound.Result round(long seed) throws Exception {
        return new SoakRound(seed, LINES, new AtomicLong()).run(folder);
    }
}
