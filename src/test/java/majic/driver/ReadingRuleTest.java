package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.bot.LinkLost;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Reading;
import majic.bot.Unit;
import majic.bot.Value;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the rule of {@link Reading}: an old reading is never returned as a present one. */
class ReadingRuleTest {
    @AutoClose
    private final SteppedBot stepped = new SteppedBot();

    private final TestClock clock = stepped.clock;
    private final FakeBot bot = stepped.bot;

    @ParameterizedTest
    @ValueSource(strings = {"x", "y", "heading", "speed", "turnRate", "moving", "distanceFront", "voltage", "light"})
    void aRobotWhoseConnectionIsLostHasNoReading(String parameter) {
        pause(1);
        bot.reportSpeed(0);
        Value before = bot.get(parameter);
        bot.cut();
        pause(3);

        assertThat(bot.get(parameter)).isEqualTo(Value.unknown("connection lost"));
        Reading old = bot.reading(parameter);
        assertThat(old.last()).isEqualTo(before);
        assertThat(old)
                .hasToString("unknown (connection lost; " + before + " at the last report, " + old.age() + " ago)");
        assertThat(old.ageS()).isGreaterThanOrEqualTo(3);
    }

    @Test
    void anOldReadingIsNoNumber() {
        bot.cut();

        assertThatThrownBy(() -> bot.get("x").number())
                .isInstanceOf(BotException.class)
                .hasMessage("not a number: unknown (connection lost)");
    }

    @ParameterizedTest
    @ValueSource(strings = {"cruise", "cruiseTurn", "maxMove", "near", "guard", "giveWay", "body"})
    void whatMajicKeepsItselfNeedsNoConnection(String parameter) {
        Value before = bot.get(parameter);
        bot.cut();

        assertThat(bot.get(parameter)).isEqualTo(before);
        assertThat(bot.reading(parameter).isCurrent()).isTrue();
    }

    @Test
    void theAgeOfTheLastReportGoesOnWithoutAConnection() {
        pause(1);
        bot.reportSpeed(0);
        bot.cut();
        pause(3);

        assertThat(bot.get("age").number()).isGreaterThanOrEqualTo(3000);
    }

    @Test
    void aRobotThatWasNeverConnectedOrIsClosedHasNoReading() {
        FakeBot unconnected = FakeBot.on(clock.time());

        assertThat(unconnected.reading("x")).hasToString("unknown (not connected)");
        bot.close();
        assertThat(bot.get("x")).isEqualTo(Value.unknown("closed"));
    }

    @Test
    void aSilentRobotHasNoReadingThoughItIsConnected() {
        try (SilentBot silent = new SilentBot(clock)) {
            silent.connect();
            pause(1);
            silent.report();
            pause(2);

            WaitPolicy.without(() -> {
                assertThat(silent.get("x")).isEqualTo(Value.unknown("no recent report"));
                assertThat(silent.reading("x"))
                        .hasToString("unknown (no recent report; 70 mm at the last report, 2 s ago)");
                assertThat(silent.get("light")).isEqualTo(Value.unknown("no recent report"));
                assertThat(silent.get("own")).isEqualTo(Value.of(3, Unit.NONE));
                assertThat(silent.get("maxMove")).isInstanceOf(Value.Number.class);
            });
        }
    }

    @Test
    void aThreadThatMayWaitGetsTheNextReport() {
        try (SilentBot silent = new SilentBot(clock)) {
            silent.connect();
            pause(1);
            silent.report();
            pause(2);
            silent.once("next report", 1, silent::report);

            assertThat(silent.get("x")).isEqualTo(Value.of(70, Unit.MM));
        }
    }

    @Test
    void aThreadThatWaitsForAReportIsToldOfTheLoss() {
        try (SilentBot silent = new SilentBot(clock)) {
            silent.connect();
            pause(1);
            silent.report();
            pause(2);
            silent.once("loss", 1, () -> silent.lost(new LinkLost("connection lost")));

            assertThat(silent.get("x")).isEqualTo(Value.unknown("connection lost"));
        }
    }

    @Test
    void aClassThatAPlugInLacksIsNamedWhereverItsCodeIsCalled() {
        try (SilentBot plugIn = new SilentBot(clock)) {
            plugIn.missing = "org/example/Gone";
            String sentence =
                    "the Fake: the driver cannot be loaded: the class org.example.Gone is missing; put the jar"
                            + " with it into the folder lib beside the plug-in's own jar";

            assertThatThrownBy(plugIn::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessage(sentence);
            plugIn.missing = "";
            plugIn.connect();
            plugIn.missing = "org/example/Gone";
            assertThatThrownBy(() -> plugIn.get("light"))
                    .isExactlyInstanceOf(BotException.class)
                    .hasMessage(sentence);
            assertThatThrownBy(() -> plugIn.set("light", 1)).hasMessage(sentence);
            assertThatThrownBy(() -> plugIn.move(100)).hasMessage(sentence);
            assertThatThrownBy(() -> plugIn.drive(100, 0)).hasMessage(sentence);
        }
    }

    private void pause(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** A robot that reports only when the test says so, and whose driver may lack a class. */
    private static final class SilentBot extends BotDriver {
        private volatile String missing = "";
        private volatile boolean light;

        SilentBot(TestClock clock) {
            super(
                    new FakeType(),
                    new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 300, 90, 500, false),
                    new BotEnvironment(clock.time(), Settings.inMemory()));
            table().add(Parameter.number("light", Unit.NONE, "how bright"), () -> {
                        useLibrary();
                        return Value.of(light ? 1 : 0, Unit.NONE);
                    })
                    .writes(values -> {
                        useLibrary();
                        light = values.get(0).number() > 0;
                    });
            table().add(Parameter.number("own", Unit.NONE, "has a time of its own"), () -> Value.of(3, Unit.NONE))
                    .measured(() -> time().nanos());
        }

        private void useLibrary() {
            if (!missing.isEmpty()) {
                throw new NoClassDefFoundError(missing);
            }
        }

        void report() {
            publish(new BotState(new Pose(70, 0, 0), 0, 0, false, time().nanos()));
        }

        @Override
        protected double longestAgeS() {
            return LONGEST_AGE_S;
        }

        @Override
        protected void open() {
            useLibrary();
        }

        @Override
        protected void shut() {}

        @Override
        protected Value moveBy(double mm, Motion motion) {
            useLibrary();
            return Value.of(mm, Unit.MM);
        }

        @Override
        protected Value turnBy(double degrees, Motion motion) {
            return Value.of(degrees, Unit.DEG);
        }

        @Override
        protected void driveAt(double mmPerSec, double degPerSec) {
            useLibrary();
        }

        @Override
        protected void halt() {}
    }
}
