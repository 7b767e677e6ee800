package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.BotException;
import majic.team.Member;
import majic.team.TeamListener;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of robots, and their use in place of numbers. */
class RobotNamesTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {"rex move 100", "REX move 100", "Rex.move(100)", "2,rex move 100", "1 move 100 until rex x > 50"
            })
    void aNameIsUsedInPlaceOfTheNumber(String line) throws InterruptedException {
        assertThat(fixture.refusal("1 name Rex")).isEmpty();
        assertThat(fixture.refusal(line)).isEmpty();
        assertThat(fixture.answers()).anyMatch(answer -> answer.startsWith("1 move 100") && answer.contains("done"));
    }

    @Test
    void aNameIsAnsweredChangedAndTakenAway() throws InterruptedException {
        List<String> answers =
                fixture.runPipe("1 name", "1 name Rex", "1 name", "rex name Max", "1 name", "max name off", "all name");
        assertThat(answers)
                .containsExactly(
                        "1 name: none",
                        "1 name Rex: done",
                        "1 name = Rex",
                        "1 name Max: done",
                        "1 name = Max",
                        "1 name off: done",
                        "1 name: none",
                        "2 name: none");
    }

    @Test
    void aRobotThatMovesIsNamedAtOnce() throws InterruptedException {
        fixture.prompt.parseText("1 move 1000");
        fixture.prompt.parseText("1 name Rex");
        assertThat(fixture.team.member(1).name()).isEqualTo("Rex");
        assertThat(fixture.team.member(1).isIdle()).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 name move | move: a word of MAJIC Script cannot be the name of a robot; take another word",
                "1 name All | All: a word of MAJIC Script cannot be the name of a robot; take another word",
                "1 name end | end: a word of MAJIC Script cannot be the name of a robot; take another word",
                "1 name bots | bots: a word of MAJIC Script cannot be the name of a robot; take another word",
                "1 name Aibo | Aibo: a type of robot cannot be a name; take another word",
                "2 name bark | bark: a command of a robot cannot be a name; take another word",
                "1 name maxine | maxine: robot 2 has this name already",
                "1 name 5 | 5: a name, one word, is expected here",
                "1 name abcdefghijklmnopqrstu | abcdefghijklmnopqrstu: a name is a letter, then letters, digits and _, at"
                        + " most 20 characters in all",
                "1 name Rex 2 | 2: nothing more is expected behind \"1 name Rex\"",
                "all name Rex | Rex: each robot has a name of its own; name one robot at a time",
                "rex move 100 | rex: no such command or robot",
                "maxin move 100 | maxin: no such command or robot; did you mean maxine?"
            })
    void whatCannotBeANameIsRefusedWithTheReason(String line, String why) throws InterruptedException {
        fixture.runPipe("2 name Maxine");
        assertThat(fixture.refusal(line)).hasValue(why);
        assertThat(fixture.team.member(1).name()).isEmpty();
    }

    @Test
    void aNameThatWasTakenAwayIsNoRobotAnyMore() throws InterruptedException {
        fixture.runPipe("1 name Rex", "1 name off");
        assertThat(fixture.refusal("rex move 100")).hasValue("rex: no such command or robot");
        fixture.runPipe("1 name Rex", "remove 1");
        assertThat(fixture.refusal("rex move 100")).hasValue("rex: no such command or robot");
    }

    @Test
    void aStopForANameThatNoRobotHasIsTakenAsStop() throws InterruptedException {
        fixture.refusal("rex stop");
        assertThat(fixture.team.isLatched()).isTrue();
    }

    @Test
    void aPipeUsesANameThatItHasGivenARobotThatIsStillBeingAdded() throws InterruptedException {
        assertThat(fixture.runPipe("add sim:aibo as 7", "7 name Rex", "rex move 100"))
                .anyMatch(answer -> answer.startsWith("7 move 100: done"));
        assertThat(fixture.pipe.allSucceeded()).isTrue();
    }

    @Test
    void aFileUsesNamesThatItGivesAndThoseThatRobotsHave() throws Exception {
        Path file = folder.resolve("names.majic");
        Files.writeString(file, "1 name Rex\nrepeat 2\n  rex,max move 100\nend\n");
        fixture.runPipe("2 name Max");
        assertThat(fixture.refusal("run " + file)).isEmpty();
        assertThat(fixture.prompt.allSucceeded()).isTrue();
        assertThat(fixture.bot(1).state().pose().xMm()).isEqualTo(200);
        assertThat(fixture.bot(2).state().pose().xMm()).isEqualTo(200);
    }

    @Test
    void aSavedSessionGivesTheNamesAgainAndHasTheNumbers() throws InterruptedException {
        fixture.runPipe("1 name Rex", "rex move 100", "rex name");
        assertThat(fixture.session.state().record().lines())
                .contains("1 name Rex", "1 move 100")
                .noneMatch(line -> line.startsWith("rex") || line.equals("1 name"));
    }

    @Test
    void namesAreShownInListsAndOfferedForCompletion() throws InterruptedException {
        fixture.runPipe("1 name Rex", "bots", "3 move 100");
        assertThat(fixture.answers())
                .contains("1: Rex (Aibo) connected, idle", "3: there is no robot 3 (robots: 1 Rex (Aibo), 2 Pioneer)");
        assertThat(fixture.prompt.complete("re", 2).words()).contains("Rex");
        assertThat(fixture.prompt.complete("rex mo", 6).words()).containsExactly("move");
        assertThat(fixture.prompt.complete("1 name o", 8).words()).containsExactly("off");
    }

    @Test
    void anEmbeddingProgramNamesRobotsAndListenersAreNotified() {
        StringBuilder heard = new StringBuilder();
        fixture.team.addListener(new TeamListener() {
            @Override
            public void renamed(Member member) {
                heard.append(member.label());
            }
        });
        fixture.team.rename(fixture.team.member(2), "Max");
        assertThat(heard).hasToString("Max (Pioneer)");
        assertThatThrownBy(() -> fixture.team.rename(fixture.team.member(1), "two words"))
                .isInstanceOf(BotException.class);
        assertThat(fixture.team.member(1).label()).isEqualTo("Aibo");
    }
}
