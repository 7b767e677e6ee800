package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.hemisson.HemissonWire.Said;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the queries to a moving robot without a watchdog: no long pause, no long query, and an immediate stop. */
class HemissonInMotionTest {
    private static final String WITH_ALL_MODULES = "kteam+camera+ultrasonic+speech+lcd+io+overrun+paced";
    private static final double MS = 1e6;

    private final List<String> told = new CopyOnWriteArrayList<>();
    private LabRig rig;
    private MajicBot bot;
    private HemissonWire wire;

    @AfterEach
    void close() {
        wire.close();
        rig.close();
    }

    @Test
    void isAskedSomethingAtLeastEvery100Milliseconds() {
        connect(WITH_ALL_MODULES);

        bot.move(300);

        assertThat(gapsMs(wire.motion("D,3,3"))).hasSizeGreaterThan(100).allMatch(gap -> gap <= 100);
    }

    @Test
    void isAskedNothingThatTakesLongerThan5MillisecondsWhateverSomebodyWants() {
        connect(WITH_ALL_MODULES);
        rig.after(0.5, () -> bot.parameters().forEach(this::read));

        bot.move(300);

        assertThat(told).anyMatch(text -> text.contains("for too long while the robot moves"));
        List<Said> motion = wire.motion("D,3,3");
        assertThat(motion).extracting(Said::text).contains("R,E0,01,03", "R,A0,10,01", "1,2");
        assertThat(HemissonWire.exchanges(motion)).hasSizeGreaterThan(100).allMatch(exchange -> exchange.lineMs() <= 5);
        assertThat(gapsMs(motion)).allMatch(gap -> gap <= 100);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.004, 1.012, 1.02, 1.028, 1.036, 1.048})
    void aStopTakesTheNextSlotOfTheLine(double seconds) throws InterruptedException {
        connect(WITH_ALL_MODULES);
        long[] stopped = new long[1];
        rig.after(seconds, () -> {
            stopped[0] = rig.lab().time().nanos();
            bot.stop();
        });

        assertThatThrownBy(() -> bot.move(300)).isInstanceOf(MotionStopped.class);
        rig.lab().time().sleep(0.2);

        Said next = wire.commandsSince(stopped[0]).get(0);
        assertThat(next.text()).isEqualTo("D,0,0");
        assertThat((next.nanos() - stopped[0]) / MS).isLessThanOrEqualTo(8);
    }

    @Test
    void aRobotThatMissesAnAnswerIsSentNothingButStopsUntilItAnswers() throws InterruptedException {
        connect("kteam+paced");
        rig.after(1, () -> rig.lab().simulators().faults("hemisson").outage(3.7));

        assertThatThrownBy(() -> bot.move(300)).isInstanceOf(BotException.class);
        rig.lab().time().sleep(4);

        List<Said> after = wire.commandsSinceFirst("D");
        List<Said> repeated = after.stream()
                .skip(1)
                .takeWhile(said -> said.text().equals("D,0,0"))
                .toList();
        assertThat(repeated).hasSizeGreaterThan(1);
        assertThat((repeated.get(0).nanos() - after.get(0).nanos()) / MS).isBetween(2000.0, 2100.0);
        assertThat(gapsMs(repeated)).allMatch(gap -> gap <= 400);
        assertThat(after.get(1 + repeated.size()).text()).isEqualTo("E");
        assertThat(bot.state().moving()).isFalse();
    }

    private void connect(String model) {
        rig = LabRig.exactWithHemisson(model);
        bot = rig.add("hemisson");
        wire = new HemissonWire(rig.lab().time());
    }

    private static List<Double> gapsMs(List<Said> said) {
        List<Said> commands = said.stream().filter(Said::byDriver).toList();
        return IntStream.range(1, commands.size())
                .mapToObj(at -> (commands.get(at).nanos() - commands.get(at - 1).nanos()) / MS)
                .toList();
    }

    private void read(Parameter parameter) {
        try {
            told.add(parameter.readable() ? bot.get(parameter.name()).toString() : "");
        } catch (BotException e) {
            told.add(e.getMessage());
        }
    }
}
