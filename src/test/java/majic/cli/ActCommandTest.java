package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import majic.program.Failures;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Tests that the act maker on the command line reports what it wrote, or in one sentence why it did not. */
@Tag("jdk")
class ActCommandTest {
    @TempDir
    Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(Object... words) {
        String[] line = Stream.of(words).map(Object::toString).toArray(String[]::new);
        return new CommandLine(new ActCommand())
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(line);
    }

    private Path source(String inside) throws IOException {
        return Files.writeString(
                folder.resolve("Nod.java"),
                "public class Nod extends majic.act.MajicAct { protected void behave() { " + inside + " } }");
    }

    @Test
    void makesAFileOfASourceAndShowsIt() throws IOException {
        Path act = folder.resolve("nod.act");
        int made = run("make", source("bot.turn(90);"), "-o", act, "--author", "Ada", "--act-version", "2");
        assertThat(made).isZero();
        assertThat(out.toString()).startsWith("wrote " + act).contains("act: Nod 2", "author: Ada", "class: Nod");
        assertThat(run("show", act)).isZero();
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void makesAFileOfAScript() throws IOException {
        Path script = Files.writeString(folder.resolve("wander.majic"), "me move 100");
        Path act = folder.resolve("wander.act");
        assertThat(run("make", script, "-o", act)).isZero();
        assertThat(out.toString()).startsWith("wrote " + act).contains("act: wander");
    }

    @Test
    void anUnsuitableSourceIsOneSentenceAndAFailure() throws IOException {
        assertThat(run("make", source("none;"), "-o", folder.resolve("nod.act")))
                .isEqualTo(Failures.FAILED);
        assertThat(err.toString())
                .startsWith("majic: Nod.java cannot be compiled: line 1: ")
                .hasLineCount(1);
        assertThat(folder.resolve("nod.act")).doesNotExist();
    }

    @Test
    void aPlaceThatCannotTakeTheFileIsNamed() throws IOException {
        Path nowhere = folder.resolve("no/such/nod.act");
        assertThat(run("make", source("bot.turn(90);"), "-o", nowhere)).isNotZero();
        assertThat(run("make", source("bot.turn(90);"), "-o", folder)).isNotZero();
        assertThat(err.toString())
                .contains(nowhere + ": there is no folder " + nowhere.getParent())
                .contains(folder + ": is a folder; name the file in it, such as " + folder.resolve("Patrol.act"))
                .hasLineCount(2);
    }

    @Test
    void aFileThatIsNoActIsOneSentenceAndAFailure() throws IOException {
        assertThat(run("show", source(""))).isEqualTo(Failures.FAILED);
        assertThat(err.toString())
                .isEqualTo(String.format("majic: Nod.java is no act: neither a jar nor a saved object%n"));
    }

    @Test
    void withoutAWordItListsTheWords() {
        assertThat(run()).isEqualTo(Failures.USAGE);
        assertThat(err.toString()).contains("make", "show");
    }

    @Test
    void makesAFileOfASavedSession() throws IOException {
        Path session = Files.writeString(
                folder.resolve("patrol.majic"), "add sim:aibo as 1\nadd sim:pioneer as 2\n1 move 100\n2 move 100\n");
        Path act = folder.resolve("patrol.act");
        assertThat(run("from-session", session, "-o", act)).isZero();
        assertThat(out.toString()).contains("act: patrol", "me aibo; robot2 pioneer");
    }

    @Test
    void aSessionThatIsNoActIsRefusedWithThePlace() throws IOException {
        Path session = Files.writeString(folder.resolve("bad.majic"), "1 move 100\nquit\n");
        assertThat(run("from-session", session)).isEqualTo(Failures.FAILED);
        assertThat(err.toString()).contains("bad.majic:2:1: quit: is for a session");
    }
}
