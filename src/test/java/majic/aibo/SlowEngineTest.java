package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.MotionReport;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A dog whose engine answers a question after two seconds. */
class SlowEngineTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @ParameterizedTest
    @CsvSource({"2000, 0", "0, 2000", "1000, 1000"})
    void theWalkContinuesPieceByPieceAndItsDistanceIsReported(long heedsLateMs, long answersLateMs) {
        dog.heedlessnessMs = heedsLateMs;
        dog.slownessMs = answersLateMs;
        aibo.connect();

        MotionReport report = aibo.move(250);

        assertThat(report.amount().number()).isCloseTo(250, within(5.0));
        assertThat(dog.guardEnded).hasValue(0);
        assertThat(pieces()).hasSize(2).allMatch(ms -> ms <= 2000);
        assertThat(dog.mostAtOnce()).isEqualTo(1);
    }

    private List<Integer> pieces() {
        return dog.received("robot.walk(").stream()
                .map(command -> Integer.parseInt(command.replaceAll(".*\\((-?\\d+)\\).*", "$1")))
                .toList();
    }
}
