package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What parameters look like on the wire, word for word but for the tags. */
class WireTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "headPan    | 30 500        | TAG+end: headPan.val = 30 time:500",
                "mouth      | -20.5 250     | TAG+end: mouth.val = -20.5 time:250",
                "tail       | 30 20 1000    | TAG+end: { tailPan.val = 30 time:1000 & tailTilt.val = 20 time:1000 }",
                "legLF1Load | 0.5           | TAG+end: legLF1.load = 0.5",
                "ears       | 1 0           | TAG+end: { earL.val = 1 & earR.val = 0 }",
                "ledF3      | 0.25          | TAG+end: ledF3.val = 0.25",
                "ledBW      | 0.5           | TAG+end: { ledBW = 0.5 }",
                "ledBC      | 0 0.5 1       | TAG+end: { ledBFC.val = 0 & ledBMC.val = 0.5 & ledBRC.val = 1 }",
                "jpegFactor | 50            | TAG+end: camera.jpegfactor = 50"
            })
    void aSettingIsOneCommandAndItsEndIsAwaited(String parameter, String values, String command) {
        aibo.connect();

        aibo.set(parameter, numbers(values));

        assertThat(said()).contains(command);
    }

    @Test
    void aQuestionIsTaggedFor10() {
        aibo.connect();

        aibo.get("ledF3");

        assertThat(said()).contains("TAG: ledF3.val").noneMatch(command -> command.contains("<<"));
    }

    @Test
    void aThreadThatMayNotWaitGetsTheReportedValue() {
        aibo.connect();
        dog.set("ledF3.val", "0.250000");

        WaitPolicy.without(() -> {
            assertThat(aibo.get("ledF3")).hasToString("unknown (the dog tells it only when asked)");
            assertThat(aibo.get("posture")).hasToString("stand");
            aibo.set("ledF3", 1);
        });

        dog.awaitReceived("ledF3.val = 1");
        assertThat(said()).doesNotContain("TAG: ledF3.val");
    }

    @Test
    void everyQuestionAndReadingGoesIntoAChannelFor15() {
        dog.speaks15 = true;
        dog.set("ledF3.val", "0.250000");
        aibo.connect();

        assertThat(aibo.get("ledF3").number()).isEqualTo(0.25);
        assertThat(aibo.get("posture")).hasToString("stand");
        assertThat(aibo.get("distanceNear")).isInstanceOf(Value.class);
        assertThat(said()).contains("TAG << ledF3.val", "TAG << robot.MyguessPosition()", "TAG << time()");
        assertThat(dog.received().stream().filter(command -> command.contains("every(64)")))
                .singleElement()
                .asString()
                .contains(" << distanceNear.val & ")
                .doesNotContain(": distanceNear");
        assertThat(driven.notices).isEmpty();
    }

    @Test
    void aServerWithoutGuardsIsReportedOnceAndTheDogWalks() {
        dog.refusesGuards = true;
        aibo.connect();

        assertThat(aibo.move(10).amount()).isEqualTo(Value.about(10, Unit.MM));

        assertThat(driven.notices)
                .containsOnlyOnce(
                        "the dog takes no guard that would end its walk when the link is lost; its walks end within 2 s");
        assertThat(dog.received("majic.").stream().filter(command -> !command.contains("1000000000000")))
                .isEmpty();
    }

    private List<String> said() {
        return dog.received().stream()
                .map(command -> command.replaceAll("mj\\w+?_\\w+", "TAG"))
                .toList();
    }

    private static List<Value> numbers(String values) {
        return Arrays.stream(values.strip().split(" "))
                .map(number -> Value.of(Double.parseDouble(number), Unit.NONE))
                .toList();
    }
}
