package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.act.make.ActMaker;
import majic.environment.Settings;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Behaviours in the user's folder: found by name, whatever the case, with blanks, as scripts and as acts. */
class OwnActsTest {
    @TempDir
    private Path folder;

    @AutoClose
    private ScriptFixture fixture;

    @BeforeEach
    void open() {
        fixture = new ScriptFixture(new ActCatalog(folder, new ActTrust(Settings.inMemory())));
        fixture.add(fixture.aibo);
        fixture.add(fixture.pioneer);
    }

    private void script(String file, String... lines) throws IOException {
        Files.write(folder.resolve(file), List.of(lines));
    }

    private void act(String file, String line) throws IOException {
        Files.write(folder.resolve(file), ActMaker.save(new ScriptAct("own.majic", line), ActDetails.named("Own")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"wander", "WANDER", "wander.majic", "\"wander\""})
    void aScriptIsFoundByItsName(String name) throws Exception {
        script("wander.majic", "me move 70");
        fixture.runPipe("2 act " + name);
        assertThat(fixture.bot(2).sent()).contains("move 70");
    }

    @ParameterizedTest
    @ValueSource(strings = {"There", "THERE", "There.act"})
    void namesAreComparedWithoutCase(String name) throws Exception {
        act("There.act", "me move 70");
        fixture.runPipe("2 act " + name);
        assertThat(fixture.bot(2).sent()).contains("move 70");
    }

    @Test
    void aNameMayHaveABlank() throws Exception {
        act("to the door.act", "me move 70");
        fixture.runPipe("2 act \"to the door\"");
        assertThat(fixture.bot(2).sent()).contains("move 70");
        assertThat(fixture.prompt.complete("2 act ", 6).words()).contains("\"to the door\"");
    }

    @ParameterizedTest
    @ValueSource(strings = {"There.act", "There.majic"})
    void theCheckedFileIsRunAlthoughItHasChangedSince(String file) throws Exception {
        write(file, "me move 70");
        fixture.prompt.parseText("2 move 4000");
        fixture.prompt.parseText("2 act " + file);
        fixture.pause(1);
        write(file, "me move -70");
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(2).sent()).contains("move 70").doesNotContain("move -70");
    }

    private void write(String file, String line) throws IOException {
        if (file.endsWith(".act")) {
            act(file, line);
        } else {
            script(file, line);
        }
    }

    @Test
    void anActInPlaceOfAShippedOneIsAnnounced() throws Exception {
        act("Guard.act", "me move 70");
        assertThat(fixture.runPipe("2 act guard", "acts"))
                .contains("2: guard from " + folder + ", in place of the one that comes with MAJIC")
                .anyMatch(
                        line -> line.startsWith("acts: Guard") && line.contains("in place of the one that comes with"));
        assertThat(fixture.bot(2).sent()).contains("move 70");
    }

    @Test
    void anActIsFoundBeforeTheScriptOfTheSameName() throws Exception {
        act("Patrol.act", "me move 70");
        script("patrol.majic", "me move 80");
        fixture.runPipe("2 act patrol", "2 wait", "2 act patrol.majic");
        assertThat(fixture.bot(2).sent()).containsSubsequence("move 70", "move 80");
    }

    @Test
    void twoActsThatDifferInCaseAloneAreRefused() throws Exception {
        act("Patrol.act", "me move 70");
        assumeFalse(Files.exists(folder.resolve("PATROL.act")), "the file system itself ignores case");
        act("PATROL.act", "me move 80");
        assertThat(fixture.runPipe("2 act patrol"))
                .singleElement()
                .asString()
                .contains("there are several of that name, PATROL.act and Patrol.act in ");
    }

    @Test
    void allAreListed() throws Exception {
        act("Patrol.act", "me move 70");
        script("wander.majic", "me move 80");
        assertThat(fixture.runPipe("acts"))
                .anyMatch(line -> line.startsWith("acts: Patrol (me"))
                .anyMatch(line -> line.startsWith("acts: wander (me"))
                .anyMatch(line -> line.startsWith("acts: AiboSquare (me"));
    }

    @Test
    void aSavedSessionNamesItsFileInFull() throws Exception {
        script("wander.majic", "me move 70");
        fixture.runPipe("2 act wander.majic", "2 wait");
        assertThat(fixture.session.state().record().lines()).contains("2 act " + folder.resolve("wander.majic"));
    }
}
