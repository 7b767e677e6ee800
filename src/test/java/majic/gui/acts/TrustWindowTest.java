package majic.gui.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import majic.act.file.ActFile;
import majic.gui.TestWindow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that nothing of an act's code is loaded before its contents are shown and the user has agreed. */
class TrustWindowTest {
    @TempDir
    private Path folder;

    private static final String LONG_NAME = "Spy".repeat(20);

    private TestWindow window;

    @BeforeEach
    void open() throws IOException {
        window = TestWindow.open(new OwnActs(folder).spy().spy(LONG_NAME).acts());
        window.add("one");
    }

    @AfterEach
    void close() {
        window.close();
        System.clearProperty(OwnActs.FLAG);
    }

    private void load() {
        load("Spy");
    }

    private void load(String act) {
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.select("acts", act);
        window.click("loadChosen");
    }

    @Test
    void enterDoesNotRunIt() {
        load();
        window.awaitDialogWithKeys("Trust this code?");
        window.press(KeyEvent.VK_ENTER);
        window.await("the question to go", () -> !window.isShowing("Trust this code? dialog"));
        assertThat(System.getProperty(OwnActs.FLAG)).isNull();
        assertThat(window.team.member(1).owner()).isNull();
        assertThat(window.parser.commands()).isEmpty();
    }

    @Test
    void itShowsTheAuthorOfTheCodeAndThePackagesThatItUses() {
        load();
        window.awaitDialog("Trust this code?");
        assertThat(window.text("trustAuthor")).startsWith("Mata Hari");
        assertThat(window.text("trustSignature")).isEqualTo("none");
        assertThat(window.text("trustHash"))
                .isEqualTo(ActFile.read(folder.resolve("Spy.act")).sha256());
        assertThat(window.text("trustClasses")).isEqualTo("Spy");
        assertThat(window.text("trustPackages")).contains("java.lang", "majic.act");
        assertThat(window.text("trustConsequence")).contains("trusted code");
        assertThat(System.getProperty(OwnActs.FLAG)).isNull();
    }

    @Test
    void aLongNameMovesNothingOffTheScreen() {
        load(LONG_NAME);
        assertThat(window.awaitDialog("Trust this code?").getWidth()).isLessThan(850);
        assertThat(window.text("trustTitle")).startsWith(LONG_NAME).endsWith("contains code that has no consent yet.");
    }

    @Test
    void afterConsentItRunsWithoutAFurtherQuestion() {
        load();
        window.click("Agree and run");
        window.await("its code to run", () -> "loaded".equals(System.getProperty(OwnActs.FLAG)));
        window.awaitMessage("agreed to its code, SHA-256");
        window.click("endAct1");
        window.await("its end", () -> window.team.member(1).isIdle());
        load();
        window.await("it to run again", () -> window.team.member(1).owner() != null);
        assertThat(window.isShowing("Trust this code? dialog")).isFalse();
    }
}
