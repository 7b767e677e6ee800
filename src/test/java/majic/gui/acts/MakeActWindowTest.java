package majic.gui.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.act.ActDetails;
import majic.act.file.ActFile;
import majic.gui.TestWindow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the window makes the same files as the act maker, and shows in words why it cannot. */
class MakeActWindowTest {
    @TempDir
    private Path folder;

    private TestWindow window;
    private OwnActs own;

    @BeforeEach
    void open() {
        own = new OwnActs(folder);
        window = TestWindow.open(own.acts());
        window.run(() -> window.frame.getJMenuBar().getMenu(2).getItem(3).doClick());
        window.awaitDialog("Make Act");
    }

    @AfterEach
    void close() {
        window.close();
        System.clearProperty(OwnActs.FLAG);
    }

    private void make() {
        window.await("something to make", () -> window.isEnabled("Make"));
        window.click("Make");
        window.await("the end", () -> window.text("makeOutcome").startsWith("Made "));
    }

    @Test
    void aSourceBecomesAnActOfTheUsersOwn() throws IOException {
        window.write("makeFrom", own.source("Spy", OwnActs.SPY).toString());
        window.await("its name", () -> window.text("makeName").equals("Spy"));
        window.write("makeAuthor", "Mata Hari");
        make();
        ActFile made = own.acts().find("Spy");
        assertThat(made.details()).isEqualTo(new ActDetails("Spy", "1.0", "Mata Hari", ""));
        assertThat(made.actClass()).isEqualTo("Spy");
    }

    @Test
    void aScriptBecomesAnActWithoutCode() throws IOException {
        Path script = Files.writeString(folder.resolve("square.majic"), "repeat 4\nme move 100\nme turn 90\nend\n");
        window.write("makeFrom", script.toString());
        make();
        assertThat(own.acts().find("square").carriesCode()).isFalse();
    }

    @Test
    void aFileThatIsNoActIsRefusedWithTheReason() throws IOException {
        window.write("makeFrom", own.source("Unfit", OwnActs.UNFIT).toString());
        window.await("why not", () -> window.text("makeOutcome").contains("has no act"));
        assertThat(window.text("makeOutcome")).doesNotContain("Exception");
        assertThat(window.isEnabled("Make")).isFalse();
    }

    @Test
    void errorsOfAScriptAreReportedWithTheirPlaces() throws IOException {
        Path script = Files.writeString(folder.resolve("bad.majic"), "me move 100\nme jump\nquit\n");
        window.write("makeFrom", script.toString());
        window.await("the mistakes", () -> window.text("makeOutcome").contains("bad.majic:3:1"));
    }

    @Test
    void aScriptThatWasMendedIsReadAgain() throws IOException {
        Path script = Files.writeString(folder.resolve("square.majic"), "move 100\n");
        window.write("makeFrom", script.toString());
        window.await("the mistake", () -> window.text("makeOutcome").contains("square.majic:1:1"));
        Files.writeString(script, "me move 100\n");
        window.write("makeFrom", script.toString());
        make();
        assertThat(own.acts().find("square").carriesCode()).isFalse();
    }

    @Test
    void aFileIsOverwrittenOnlyOnceThatWasAgreedTo() throws IOException {
        Path there = Files.writeString(folder.resolve("Spy.act"), "precious");
        window.write("makeFrom", own.source("Spy", OwnActs.SPY).toString());
        window.await("its name", () -> window.text("makeName").equals("Spy"));
        window.await("something to make", () -> window.isEnabled("Make"));
        window.click("Make");
        window.awaitDialog("MAJIC asks");
        window.click("No");
        assertThat(there).hasContent("precious");
    }

    @Test
    void aNameThatIsNoFileIsRefusedWithTheReason() throws IOException {
        window.write("makeFrom", own.source("Spy", OwnActs.SPY).toString());
        window.await("its name", () -> window.text("makeName").equals("Spy"));
        window.await("something to make", () -> window.isEnabled("Make"));
        window.write("makeTarget", "");
        window.push("Make");
        window.await("the missing file", () -> window.text("makeOutcome").contains("is missing"));
        window.write("makeTarget", "spy\0.act");
        window.push("Make");
        window.await("why not", () -> window.text("makeOutcome").contains("Nul character"));
        assertThat(window.isEnabled("Make")).isTrue();
    }

    @Test
    void anErrorInAnActsOwnCodeIsReportedAndLeavesTheWindowUsable() throws IOException {
        String failing = "public class Failing extends majic.act.MajicAct {"
                + " public java.util.List<majic.act.Role> roles() { throw new AssertionError(\"no idea\"); }"
                + " protected void behave() {} }";
        window.write("makeFrom", own.source("Failing", failing).toString());
        window.await("something to make", () -> window.isEnabled("Make"));
        window.click("Make");
        window.await("why not", () -> window.text("makeOutcome").contains("failed in its roles()"));
        assertThat(window.isEnabled("Make")).isTrue();
    }
}
