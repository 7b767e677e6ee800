package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.script.help.Completions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a line without robots is for the default robots of its parser. */
class DefaultRobotsTest {
    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    private List<Integer> selected = List.of(1, 2);

    @BeforeEach
    void addTwo() throws InterruptedException {
        fixture.prompt.parseText("add sim:aibo");
        fixture.prompt.parseText("add sim:pioneer");
        fixture.prompt.awaitAll();
        fixture.prompt.useDefaultRobots(() -> selected);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "move 100 | 1,2 move 100",
                "MOVE 100 | 1,2 MOVE 100",
                "move(100) | 1,2.move(100)",
                "get x,y | 1,2 get x,y",
                "log off | 1,2 log off",
                "wag 1 | 1,2 wag 1",
                "2 move 100 | 2 move 100",
                "all move 100 | all move 100",
                "pioneer move 100 | pioneer move 100",
                "bots | bots",
                "stop | stop"
            })
    void aLineGetsTheNumbersOfTheRobotsIfItNamesNoneAndIsForRobots(String typed, String passedOn) {
        assertThat(fixture.prompt.parseText(typed)).isEmpty();
        assertThat(fixture.prompt.commands()).endsWith(passedOn);
    }

    @Test
    void withoutRobotsTheLineIsRefusedAndTheRefusalStatesWhatWouldBeRight() {
        selected = List.of();
        assertThat(fixture.prompt.parseText("move 100"))
                .hasValue("move: which robot? Write its number in front, as in \"1 move\"");
    }

    @Test
    void aSavedSessionHasTheNumbers() throws InterruptedException {
        fixture.prompt.parseText("move 100");
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines()).contains("1,2 move 100");
    }

    @Test
    void aLineOfABlockGetsTheNumbersOfTheRobotsThatAreSelectedWhenItIsTyped() throws InterruptedException {
        fixture.prompt.parseText("repeat 2");
        fixture.prompt.parseText("move 10");
        selected = List.of(2);
        fixture.prompt.parseText("turn 10");
        assertThat(fixture.prompt.parseText("end")).isEmpty();
        assertThat(fixture.prompt.commands()).contains("1,2 move 10", "2 turn 10");
    }

    @Test
    void theWordsOfALineWithoutRobotsAreCompletedForThem() {
        selected = List.of(1);
        Completions found = fixture.prompt.complete("set headP", 9);
        assertThat(found.words()).containsExactly("headPan");
        assertThat(found.start()).isEqualTo(4);
        assertThat(fixture.prompt.complete("mo", 2).words()).containsExactly("move");
    }

    @Test
    void aRefusalHasThePlaceInTheLineAsItWasTyped() {
        assertThat(fixture.prompt.submit("set headPan far", later -> {})).hasValueSatisfying(refusal -> {
            assertThat(refusal.from()).isEqualTo(12);
            assertThat(refusal.to()).isEqualTo(15);
        });
    }
}
