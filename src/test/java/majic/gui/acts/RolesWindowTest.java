package majic.gui.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that an act with further roles gets suitable robots that are free. */
class RolesWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private TestWindow window;

    private OwnActs own;

    @BeforeEach
    void open() throws IOException {
        own = new OwnActs(folder);
        window = TestWindow.open(own.script("Relay", "repeat", "1 move 100", "2 move 200", "wait", "wait 100ms", "end")
                .script("Trio", "1 move 100", "2 move 100", "3 move 100")
                .script("WithDog", "add sim:toy as 1", "add sim:aibo as 2", "1 move 100", "2 move 100")
                .acts());
    }

    private void choose(String act) {
        window.click("Load Act");
        window.awaitDialog("Load Act");
        window.click("OK");
        window.select("acts", act);
        window.click("loadChosen");
        window.awaitDialog("Assign Roles");
    }

    @Test
    void theRobotsAssignedPlayTheirParts() {
        ToyBot one = window.add("one");
        ToyBot two = window.add("two");
        choose("Relay");
        window.click("loadChosen");
        window.await("both to move", () -> one.told.contains("move 100") && two.told.contains("move 200"));
        assertThat(window.parser.commands()).containsExactly("1 act Relay with 2");
    }

    @Test
    void anUnsuitableRobotIsNotOfferedAndTheReasonIsShown() {
        window.add("one");
        window.add("two");
        choose("WithDog");
        assertThat(window.text("why robot2")).contains("Wanted: aibo.", "Robot 2 is of type toy, not aibo.");
        assertThat(window.isEnabled("loadChosen")).isFalse();
    }

    @Test
    void oneRobotCannotPlayTwoParts() {
        window.add("one");
        window.add("two");
        choose("Trio");
        window.click("loadChosen");
        window.await("the words", () -> window.text("rolesOutcome").startsWith("One robot cannot have two roles"));
        assertThat(window.parser.commands()).isEmpty();
    }

    @Test
    void aRoleThatTakesMoreIsPlayedByAsManyAsChosen() throws IOException {
        own.convoy();
        window.add("one");
        ToyBot two = window.add("two");
        ToyBot three = window.add("three");
        choose("Together");
        window.push("One more");
        window.await("one more", () -> window.isShowing("role follower 2"));
        assertThat(window.isEnabled("One more")).isFalse();
        window.push("loadChosen");
        window.await("both to move", () -> two.told.contains("move 30") && three.told.contains("move 30"));
        assertThat(window.parser.commands()).containsExactly("1 act Together with 2,3");
    }

    @Test
    void oneFewerIsBackAtOne() throws IOException {
        own.convoy();
        window.add("one");
        window.add("two");
        window.add("three");
        choose("Together");
        window.push("One more");
        window.await("one more", () -> window.isShowing("role follower 2"));
        window.push("One fewer");
        window.await("one fewer", () -> !window.isShowing("role follower 2"));
        assertThat(window.isEnabled("One fewer")).isFalse();
    }

    @Test
    void aRobotThatRunsAnotherActIsNotOffered() {
        window.add("one");
        window.add("two");
        window.parser.parseText("2 act Relay with 1");
        window.await("it to run", () -> window.team.member(1).owner() != null);
        window.add("three");
        window.click("tab3");
        choose("Relay");
        assertThat(window.text("why robot2")).contains("Robot 1 is running Relay.", "Robot 2 is running Relay.");
        assertThat(window.isEnabled("loadChosen")).isFalse();
    }
}
