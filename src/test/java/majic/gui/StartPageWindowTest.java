package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StartPageWindowTest {
    private final Locale language = Locale.getDefault();

    @AfterEach
    void setLanguageBack() {
        Language.use(language);
    }

    @Test
    void allButtonsAreInASmallWindowWithLargeGermanTexts() {
        try (TestWindow window = TestWindow.openWith("window.language", "de")) {
            window.run(() -> {
                window.frame.setSize(1280, 800);
                LookAndFeels.changeTextSize(150, window.settings);
            });
            try {
                window.await("five whole buttons", () -> wholeButtons(window) == 5);
            } finally {
                window.run(() -> LookAndFeels.changeTextSize(100, window.settings));
            }
        }
    }

    private static long wholeButtons(TestWindow window) {
        JComponent page = window.find("startPage", JComponent.class);
        Container column = (Container) page.getComponent(0);
        return GuiActionRunner.execute(() -> Stream.of(column.getComponents())
                .filter(AbstractButton.class::isInstance)
                .filter(button -> page.getVisibleRect()
                        .contains(SwingUtilities.convertRectangle(column, button.getBounds(), page)))
                .count());
    }

    @Test
    void isShownUntilThereIsARobotAndAgainWhenTheLastIsGone() {
        try (TestWindow window = TestWindow.open()) {
            assertThat(window.isShowing("startPage")).isTrue();
            window.add("//one");
            assertThat(window.isShowing("startPage")).isFalse();
            window.command("remove 1");
            window.await("the page", () -> window.isShowing("startPage"));
        }
    }

    @Test
    void startsTheLabWithItsRobots() {
        try (TestWindow window = TestWindow.open()) {
            window.push("Start the simulated lab");
            window.await("the lab's robot", () -> window.tabs().contains("1"));
            window.command("remove 1");
            window.await("the page", () -> window.isShowing("startPage"));
            assertThat(window.isEnabled("Start the simulated lab")).isFalse();
        }
    }

    @Test
    void withoutAnEarlierTeamItsButtonIsGrey() {
        try (TestWindow window = TestWindow.open()) {
            assertThat(window.isEnabled("Yesterday's team")).isFalse();
        }
    }

    @Test
    void aGreyButtonKeepsItsPicture() {
        try (TestWindow window = TestWindow.open()) {
            assertThat(leftEdge(window, "Yesterday's team heading")).isEqualTo(leftEdge(window, "Add a robot heading"));
        }
    }

    private static int leftEdge(TestWindow window, String name) {
        return window.awaitShowing(name, JLabel.class).getLocationOnScreen().x;
    }

    @Test
    void addsTheRobotsOfTheLastTeam() {
        try (TestWindow window = TestWindow.openWith(
                "team.last",
                "add toy://one as 2\n2 set pose 100 200 90\nadd toy://absent as 3\nadd toy://two as 4\n")) {
            window.await("the team", () -> window.isEnabled("Yesterday's team"));
            assertThat(window.text("Yesterday's team detail")).isEqualTo("2 Toy, 3 Toy, 4 Toy");
            window.push("Yesterday's team");
            window.await("the robots", () -> window.tabs().size() == 2);
            window.await(
                    "its place", () -> window.frame.getBot(2).state().pose().equals(new Pose(100, 200, 90)));
            window.awaitMessage("nothing answers at //absent");
        }
    }

    @Test
    void aDamagedTeamIsReportedAndKeptAndNotReplacedByTheNext() {
        String damaged = "add toy://one as 2\n2 se";
        try (TestWindow window = TestWindow.openWith("team.last", damaged)) {
            window.awaitMessage("the team of the last session was damaged (line 2: \"2 se\"");
            assertThat(window.isEnabled("Yesterday's team")).isFalse();
            window.command("add toy://bench as 5");
            window.await(
                    "the team",
                    () -> !window.settings.get("team.last").orElseThrow().isEmpty());
            assertThat(window.settings.get("team.last.damaged")).contains(damaged);
        }
    }

    @Test
    void aTeamWithARobotOfTheLabStartsTheLab() {
        try (TestWindow window = TestWindow.openWith("team.last", "add sim:toy as 1\n")) {
            window.await("the team", () -> window.isEnabled("Yesterday's team"));
            window.push("Yesterday's team");
            window.await("the robot", () -> window.tabs().contains("1"));
        }
    }

    @Test
    void theTeamIsKeptForTheNextStart() {
        try (TestWindow window = TestWindow.open()) {
            window.command("add toy://bench as 5");
            window.await("the team", () -> window.settings.get("team.last").isPresent());
            assertThat(window.settings.get("team.last").orElseThrow()).contains("add toy://bench as 5");
            assertThat(window.settings.get("robots.recent")).contains("toy://bench");
        }
    }

    @Test
    void aTeamThatWasSavedCanBeOpened(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("lab.team"), "add toy://one as 7\n");
        try (TestWindow window = TestWindow.open()) {
            window.run(window.entry("Open Team…")::doClick);
            window.chooseFile(file);
            window.await("the robot", () -> window.tabs().contains("7"));
        }
    }

    @Test
    void aFileThatIsNoTeamIsRefusedWithTheLine(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("lab.team"), "add toy://one as 7\n7 move 100\n");
        try (TestWindow window = TestWindow.open()) {
            window.run(window.entry("Open Team…")::doClick);
            window.chooseFile(file);
            window.awaitMessage("lab.team:2: \"7 move 100\" is no line of a saved team");
            assertThat(window.frame.totalBots()).isZero();
        }
    }

    @Test
    void theTourWaitsUntilEachStepIsDone() {
        try (TestWindow window = TestWindow.open()) {
            window.push("Tour");
            window.awaitDialog("Tour");
            assertThat(window.text("tourCount")).startsWith("Step 1 of");
            assertThat(window.isEnabled("Next")).isFalse();
            while (!window.text("tourTitle").equals("STOP")) {
                window.push("Skip");
            }
            window.add("//one");
            assertThat(window.isEnabled("Next")).isFalse();
            window.run(window.team::stopAll);
            window.await("the step", () -> window.isEnabled("Next"));
            window.push("Next");
            assertThat(window.text("tourTitle")).isEqualTo("Release");
            window.push("Close");
            assertThat(window.isShowing("Tour dialog")).isFalse();
        }
    }
}
