package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalDateTime;
import java.time.ZoneId;
import org.junit.jupiter.api.Test;

/** Tests how the origin of a STOP is described. */
class StopOriginTest {
    @Test
    void theTimeOfAnEarlierDayHasItsDate() {
        LocalDateTime pressed = LocalDateTime.of(2026, 1, 5, 14, 2, 59);

        StopOrigin origin = new StopOrigin(
                "Anna at desk1", pressed.atZone(ZoneId.systemDefault()).toInstant());

        assertThat(origin).hasToString("STOP by Anna at desk1, pressed at 2026-01-05 14:02,");
    }

    @Test
    void aTimeThatIsNotKnownIsLeftOut() {
        assertThat(new StopOrigin("Anna at desk1", null)).hasToString("STOP by Anna at desk1");
    }
}
