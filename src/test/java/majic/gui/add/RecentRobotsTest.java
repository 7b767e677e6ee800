package majic.gui.add;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import majic.environment.Settings;
import org.junit.jupiter.api.Test;

class RecentRobotsTest {
    private final Settings settings = Settings.inMemory();
    private final RecentRobots recent = new RecentRobots(settings);

    @Test
    void theNewestIsFirstAndEachIsThereOnce() {
        recent.keep(List.of("aibo://a", "pioneer://b"));
        recent.keep(List.of("AIBO://a"));

        assertThat(recent.all()).containsExactly("AIBO://a", "pioneer://b");
    }

    @Test
    void onlyTheLastTwelveAreKept() {
        recent.keep(IntStream.range(0, 20).mapToObj(n -> "aibo://" + n).toList());

        assertThat(recent.all()).hasSize(12).startsWith("aibo://19");
    }

    @Test
    void robotsOfTheLabAreNotKept() {
        recent.keep(List.of("sim:pioneer"));

        assertThat(recent.all()).isEmpty();
    }

    @Test
    void damagedSettingsAreLeftOut() {
        settings.put("robots.recent", "nonsense\nhemisson:COM3\n\n:");

        assertThat(recent.all()).containsExactly("hemisson:COM3");
    }
}
