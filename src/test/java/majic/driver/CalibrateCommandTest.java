package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotCommand;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.CalibrateCommand.Trial;
import majic.environment.BotEnvironment;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class CalibrateCommandTest {
    private final List<Double> learned = new ArrayList<>();

    @AutoClose
    private final FakeBot bot = new FakeBot(new FakeType(), BotEnvironment.plain());

    @BeforeEach
    void connect() {
        bot.add(CalibrateCommand.of(new CalibrateCommand.CalibratedRobot() {
            @Override
            public List<String> directions() {
                return List.of("forward", "left");
            }

            @Override
            public Trial go(String direction, Motion motion) {
                Unit unit = direction.equals("left") ? Unit.DEG : Unit.MM;
                return new Trial(1000, unit, new Range(80, 3000), measured -> "learned " + learned.add(measured));
            }
        }));
        bot.connect();
    }

    @Test
    void movesFirstAndAnswersWhatToMeasureAndType() {
        assertThat(calibrate("forward"))
                .isEqualTo("it takes this for about 1000 mm; measure it and type what you saw, as in: "
                        + "calibrate forward 1000mm");
        assertThat(calibrate("left")).contains("a whole turn counts 360").endsWith("calibrate left 1000deg");
    }

    @Test
    void takesWhatWasMeasuredAndALaterCorrection() {
        calibrate("forward");

        calibrate("FORWARD", Value.of(94, Unit.NONE));
        calibrate("forward", Value.of(941, Unit.MM));

        assertThat(learned).containsExactly(94.0, 941.0);
    }

    @Test
    void refusesWhatWasNotMovedYetEvenIfAnotherWayWas() {
        calibrate("left");

        assertThatThrownBy(() -> calibrate("forward", Value.of(940, Unit.MM)))
                .hasMessage(
                        "calibrate forward 940 mm: nothing to measure yet; \"calibrate forward\" alone moves it first");
    }

    @Test
    void refusesAnotherUnitASignAndWords() {
        calibrate("forward");

        List<Value> wrong =
                List.of(Value.of(940, Unit.DEG), Value.of(-940, Unit.MM), Value.of(0, Unit.MM), Value.text("far"));

        assertThat(wrong)
                .allSatisfy(value -> assertThatThrownBy(() -> calibrate("forward", value))
                        .hasMessageEndingWith("type how far it went as a number above 0 in mm, without a sign"));
        assertThat(learned).isEmpty();
    }

    @Test
    void refusesAnImpossibleMeasurement() {
        calibrate("forward");

        assertThatThrownBy(() -> calibrate("forward", Value.of(9410, Unit.MM)))
                .hasMessage("calibrate forward 9410 mm: it cannot have gone so far or so little in that time; "
                        + "between 80 and 3000 mm would do");
        assertThat(learned).isEmpty();
    }

    @Test
    void isWrittenWithItsDirectionAndPerhapsAMeasure() {
        BotCommand command = bot.commands().get(2);

        assertThat(command.usage()).isEqualTo("calibrate DIRECTION [MEASURED]");
        assertThat(command.takes(0)).isFalse();
        assertThat(command.takes(2)).isTrue();
        assertThat(command.takes(3)).isFalse();
        assertThat(command.argument(2)).isNull();
    }

    private String calibrate(String direction, Value... measured) {
        List<Value> arguments = new ArrayList<>(List.of(Value.text(direction)));
        arguments.addAll(List.of(measured));
        return bot.run("calibrate", arguments);
    }
}
