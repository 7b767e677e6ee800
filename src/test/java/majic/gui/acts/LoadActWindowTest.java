package majic.gui.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.team.Owner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that an act is loaded onto a robot by clicks, that nothing happens before the last of them, and that one click
 * ends it.
 */
class LoadActWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private TestWindow window;

    private OwnActs own;

    @BeforeEach
    void open() throws IOException {
        own = new OwnActs(folder).endless("Ahead", 100).endless("Other", 200);
        window = TestWindow.open(own.acts());
    }

    private void choose(String act) {
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.select("acts", act);
    }

    private void load(String act) {
        choose(act);
        window.click("loadChosen");
    }

    private void awaitRunning(int robot, String act) {
        window.await(act + " to run", () -> {
            Owner owner = window.team.member(robot).owner();
            return owner != null && owner.name().equals(act);
        });
    }

    private void awaitFree(int robot) {
        window.await(
                "robot " + robot + " to be free",
                () -> window.team.member(robot).owner() == null);
    }

    private void askToReplace() {
        load("Ahead");
        awaitRunning(1, "Ahead");
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.awaitDialog("MAJIC asks");
    }

    @Test
    void theChoiceIsExecutedAsATypedLine() {
        ToyBot bot = window.add("one");
        load("Ahead");
        awaitRunning(1, "Ahead");
        window.awaitMessage("1 act Ahead");
        window.await("its motion", () -> bot.told.contains("move 100"));
        assertThat(window.parser.commands()).containsExactly("1 act Ahead");
    }

    @Test
    void cancelBeforeItIsLoadedChangesNothing() {
        ToyBot bot = window.add("one");
        choose("Ahead");
        window.click("Cancel");
        assertThat(window.team.member(1).owner()).isNull();
        assertThat(window.parser.commands()).isEmpty();
        assertThat(bot.told).isEmpty();
    }

    @Test
    void noToTheQuestionLeavesTheOldOneRunning() {
        window.add("one");
        askToReplace();
        Owner before = window.team.member(1).owner();
        window.click("No");
        assertThat(window.isShowing("Choose Act dialog")).isFalse();
        assertThat(window.team.member(1).owner()).isSameAs(before);
        assertThat(window.parser.commands()).containsExactly("1 act Ahead");
    }

    @Test
    void yesAndThenCancelLeavesTheOldOneRunning() {
        window.add("one");
        askToReplace();
        Owner before = window.team.member(1).owner();
        window.click("Yes");
        window.awaitDialog("Choose Act");
        window.click("Cancel");
        assertThat(window.team.member(1).owner()).isSameAs(before);
    }

    @Test
    void yesEndsTheOldOneAndThenStartsTheNewOne() {
        ToyBot bot = window.add("one");
        askToReplace();
        window.click("Yes");
        window.select("acts", "Other");
        window.click("loadChosen");
        awaitRunning(1, "Other");
        window.await("its motion", () -> bot.told.contains("move 200"));
        assertThat(bot.told).containsSubsequence("move 100", "halt", "move 200");
        assertThat(bot.told.lastIndexOf("move 100")).isLessThan(bot.told.indexOf("move 200"));
    }

    @Test
    void anActIsLoadedOntoEachOfTheSelectedRobotsAndTheKeyEndsAllOfThem() {
        ToyBot one = window.add("one");
        ToyBot two = window.add("two");
        window.clickWithCtrl("tab2");
        load("Ahead");
        window.await("both motions", () -> one.told.contains("move 100") && two.told.contains("move 100"));
        awaitRunning(1, "Ahead");
        awaitRunning(2, "Ahead");
        assertThat(window.parser.commands()).containsExactly("1 act Ahead", "2 act Ahead");
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_E);
        window.awaitMessage("1,2 act off");
        awaitFree(1);
        awaitFree(2);
    }

    @Test
    void thePanelShowsWhatRunsAndOneClickEndsIt() {
        ToyBot bot = window.add("one");
        load("Ahead");
        window.await(
                "its name",
                () -> window.isShowing("act1") && window.text("act1").equals("Ahead"));
        assertThat(window.text("actTime1")).matches("0:\\d\\d");
        window.click("endAct1");
        awaitFree(1);
        window.await("the bar to go", () -> !window.isShowing("act1"));
        assertThat(bot.told).endsWith("halt");
        window.awaitMessage("1 act off: done");
    }

    @Test
    void theKeyEndsTheActOfTheSelectedRobot() {
        window.add("one");
        load("Ahead");
        awaitRunning(1, "Ahead");
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_E);
        awaitFree(1);
    }

    @Test
    void itsMessageIsShownBesideItsName() throws IOException {
        own.spy();
        window.add("one");
        load("Spy");
        window.click("Agree and run");
        window.await(
                "its words",
                () -> window.isShowing("actSaid1") && window.text("actSaid1").equals("here I am"));
        window.awaitMessage("1: Spy: here I am");
    }

    private void chooseFromFile(Path file) {
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.click("From a file…");
        window.chooseFile(file);
    }

    @Test
    void aFilePickedInTheFileChooserIsLoaded() throws IOException {
        Path script = Files.writeString(
                Files.createDirectory(folder.resolve("else where")).resolve("there.majic"), "me move 60\n");
        ToyBot bot = window.add("one");
        chooseFromFile(script);
        window.await("it in the list", () -> window.text("actTitle").equals("there"));
        window.click("loadChosen");
        window.await("its motion", () -> bot.told.contains("move 60"));
        assertThat(window.parser.commands()).containsExactly("1 act \"" + script + "\"");
    }

    @Test
    void aFileWithoutAnActIsReportedAndNothingIsChosen() throws IOException {
        window.add("one");
        chooseFromFile(Files.writeString(folder.resolve("bad.majic"), "me jump\nquit\n"));
        window.await("the mistakes", () -> window.text("actNote").contains("bad.majic:2:1"));
        assertThat(window.isEnabled("loadChosen")).isFalse();
    }

    @Test
    void anActWithinAScriptEndsWithItsScript() throws IOException {
        Path script = Files.writeString(folder.resolve("rounds.majic"), "repeat\n1 act Ahead\nend\n");
        ToyBot bot = window.add("one");
        window.parser.parseText("run \"" + script + "\"");
        awaitRunning(1, "Ahead");
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.awaitDialog("MAJIC asks");
        window.click("Yes");
        window.select("acts", "Other");
        window.click("loadChosen");
        awaitRunning(1, "Other");
        window.await("its motion", () -> bot.told.contains("move 200"));
    }

    @Test
    void aDamagedFileIsReportedInASentenceAndCannotBeLoaded() throws IOException {
        Files.writeString(folder.resolve("Broken.act"), "PK but not a jar");
        window.add("one");
        choose("Broken");
        assertThat(window.text("actNote")).startsWith("Broken.act").doesNotContain("Exception");
        assertThat(window.isEnabled("loadChosen")).isFalse();
    }

    @Test
    void anUnsuitableRobotIsRefusedWithTheReason() throws IOException {
        own.script("Dogs", "add sim:aibo as 1", "1 move 100");
        window.add("one");
        choose("Dogs");
        assertThat(window.text("actNote")).isEqualTo("Robot 1 is of type toy, not aibo.");
        assertThat(window.isEnabled("loadChosen")).isFalse();
    }

    @Test
    void theLineNamesOnlyTheArgumentsThatDifferFromTheirDefaults() throws IOException {
        own.script(
                "Far",
                "argument distance = 300mm from 100 to 900 \"how far\"",
                "argument times = 1",
                "argument side = left or right",
                "repeat $times",
                "me move $distance",
                "end");
        ToyBot bot = window.add("one");
        choose("Far");
        assertThat(window.text("argument distance")).isEqualTo("300");
        window.write("argument distance", "4000");
        assertThat(window.isEnabled("loadChosen")).isFalse();
        assertThat(window.text("purpose distance")).isEqualTo("Enter a number from 100 to 900.");
        window.write("argument distance", "400");
        assertThat(window.text("purpose distance")).isEqualTo("how far");
        window.run(() -> window.find("argument side", JComboBox.class).setSelectedItem("right"));
        window.click("loadChosen");
        window.await("its motion", () -> bot.told.contains("move 400"));
        assertThat(window.parser.commands()).containsExactly("1 act Far distance=400mm side=right");
    }

    @Test
    void aLongExplanationOfAnArgumentIsWrapped() throws IOException {
        own.script(
                "Far", "argument distance = 300mm \"" + "how far it is to go ".repeat(8) + "\"", "me move $distance");
        window.add("one");
        choose("Far");
        for (String part : List.of("argument distance", "purpose distance")) {
            JComponent shown = window.find(part, JComponent.class);
            assertThat(shown.getVisibleRect().width).isEqualTo(shown.getWidth());
        }
    }

    @Test
    void anActWithoutArgumentsShowsNoForm() {
        window.add("one");
        choose("Ahead");
        assertThat(window.isShowing("argumentsTitle")).isFalse();
        window.click("Cancel");
    }
}
