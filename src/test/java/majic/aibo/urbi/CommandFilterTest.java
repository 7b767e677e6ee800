package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandFilterTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "undefall;",
                "1; stopall",
                "t: reset,",
                "{ wait(1); reboot }",
                "/* all over */ shutdown;",
                "stop notag,",
                "stop walk, stop notag",
                "headPan.val->unit;",
                "x -> unit",
                "headPan = \"30\"",
                "legLF1.val = \"30\" time:100",
                "exec(\"reset;\")",
                "echo \"http://aibo\"; stopall",
                "a = \"/*\"; reset; b = \"*/\"",
                "# it is 5\" long\nstopall; echo \"done\"",
            })
    void whatHarmsADogIsRefused(String commands) {
        assertThatThrownBy(() -> CommandFilter.check(commands))
                .isInstanceOf(UrbiRefusal.class)
                .hasMessageContaining("is never sent to a dog");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "stop walk, stop turn, stop mj1_7,",
                "speaker.play(\"reset.wav\")",
                "x.reset = 1",
                "echo \"stopall\"",
                "// reboot it by hand\nping",
                "mj.text = \"a\"",
                "headPan.val = 30 time:500",
                "headPan.val->rangemin",
            })
    void whatOnlyLooksLikeItPasses(String commands) {
        assertThatCode(() -> CommandFilter.check(commands)).doesNotThrowAnyException();
    }

    @Test
    void aCommandLongerThanTheDogsQueueIsRefused() {
        assertThatThrownBy(() -> CommandFilter.check("x = " + "1".repeat(32_000)))
                .hasMessage("a command of 32004 bytes is too long for the dog, which takes 32000 at most");
    }
}
