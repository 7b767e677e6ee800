package majic.gui.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.event.KeyEvent;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JSlider;
import majic.bot.BotException;
import majic.bot.DriveGuard;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.command.CommandLine;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class DriveByHandWindowTest {
    private static final String AHEAD = "drive 200 0";

    private final TestWindow window = TestWindow.open();
    private final ToyBot bot = window.add("one");

    @AfterEach
    void close() {
        window.letGo(KeyEvent.VK_UP);
        window.close();
    }

    @Test
    void aHeldArrowKeyDrivesAgainAndAgainAndLettingGoStops() {
        holdUp();
        window.await(
                "three drives without a halt between them",
                () -> Collections.indexOfSubList(bot.told, Collections.nCopies(3, AHEAD)) >= 0);
        window.letGo(KeyEvent.VK_UP);
        awaitStationary();
    }

    @Test
    void ctrlDGoesToThePad() {
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_D);
        window.hold(KeyEvent.VK_UP);
        window.await("a drive", () -> bot.told.contains(AHEAD));
        window.letGo(KeyEvent.VK_UP);
        awaitStationary();
    }

    @Test
    void losingTheFocusStops() {
        holdUp();
        window.run(() -> window.find("commandLine", CommandLine.class).requestFocus());
        awaitStationary();
    }

    @Test
    void aHeldRobotRefusesMotionFromElsewhere() {
        holdUp();
        assertThatThrownBy(() -> window.team.member(1).check(true, null))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("driven by hand");
    }

    @Test
    void stopEndsTheHandThoughTheKeyIsStillHeld() {
        holdUp();
        window.press(KeyEvent.VK_F12);
        awaitStationary();
    }

    @Test
    void anArrowButtonDrivesWhileTheMouseHoldsIt() {
        window.holdMouse("drive LEFT");
        window.await("a turn", () -> bot.told.contains("drive 0 40"));
        window.letGoMouse();
        awaitStationary();
    }

    @Test
    void pageDownAndPageUpOnThePadChangeTheSpeed() {
        window.focus("drivePad");
        window.press(KeyEvent.VK_PAGE_DOWN);
        window.press(KeyEvent.VK_PAGE_DOWN);
        window.press(KeyEvent.VK_PAGE_UP);
        JSlider speed = window.find("driveSpeed", JSlider.class);
        window.await("the speed", () -> speed.getValue() == 90);
    }

    @Test
    void theGuardIsOnAndTheSignTellsWhatHoldsTheRobot() {
        awaitSign("No guard: it has no sensors for it");
        bot.useGuard(new Near());
        window.team.member(1).bot().place(Pose.START);
        awaitSign("Guard: on");

        holdUp("drive 62.5 0");
        bot.at(Pose.START, true);

        awaitSign("a chair is 220 mm ahead");
        window.letGo(KeyEvent.VK_UP);
        awaitStationary();
        bot.at(Pose.START, false);
        awaitSign("Guard: on");
    }

    @Test
    void theGuardCanBeSwitchedOffWhichIsKept() {
        bot.useGuard(new Near());
        window.click("driveGuard");
        awaitSign("Guard: off");

        holdUp();

        window.await("the setting", () -> window.settings.get("drive.guard").equals(Optional.of("off")));
    }

    /** Leaves little room. */
    private static final class Near implements DriveGuard {
        @Override
        public boolean isPossible() {
            return true;
        }

        @Override
        public Room room(double mmPerSec, double degPerSec) {
            return new Room(23.4375, "a chair is 220 mm ahead");
        }
    }

    private void awaitSign(String text) {
        window.await(text, () -> window.text("driveGuard").equals(text));
    }

    @Test
    void theReasonWhyARobotCannotBeDrivenIsShownOnce() {
        window.team.stopAll();
        window.focus("drivePad");
        window.hold(KeyEvent.VK_UP);
        window.awaitMessage("STOP is latched; \"release\" allows motion again");
        assertThat(bot.told).doesNotContain(AHEAD);
    }

    @Test
    void whileStopIsLatchedThePadLooksDisabledAndShowsWhy() {
        window.team.stopAll();
        awaitHint("STOP is latched; Release");
        assertThat(window.isEnabled("drive LEFT")).isFalse();
        window.team.release();
        awaitHint("Click here to drive");
        assertThat(window.isEnabled("drive LEFT")).isTrue();
    }

    @Test
    void whileAnActRunsThePadLooksDisabledAndShowsWhy() {
        Owner act = new Owner(Owner.Kind.ACT, "Wander", () -> {});
        window.team.member(1).claim(act);
        awaitHint("running Wander; Stop 1 ends it");
        assertThat(window.isEnabled("drive LEFT")).isFalse();
        window.team.member(1).free(act);
        awaitHint("Click here to drive");
    }

    @Test
    void theReasonOfTheTeamIsInTheLanguageOfTheWindow() {
        CountDownLatch end = new CountDownLatch(1);
        Member member = window.team.member(1);
        assertThatThrownBy(() -> fillQueue(member, end)).isInstanceOf(BotException.class);
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMAN);
            DriveObstacles full = DriveObstacles.of(List.of(member));

            assertThat(full.text(false))
                    .isEqualTo("1: seine Warteschlange ist voll (100 Befehle); warten Sie, oder „1 stop“ leert sie");
            assertThat(full.details()).endsWith(full.text(false));
        } finally {
            Locale.setDefault(before);
            end.countDown();
        }
    }

    /** Submits commands until one is refused, once the first has left the queue to wait for a latch. */
    private static void fillQueue(Member member, CountDownLatch end) {
        CountDownLatch begun = new CountDownLatch(1);
        while (true) {
            member.submit(
                    new QueuedCommand("turn 5", true, robot -> {
                        begun.countDown();
                        return awaited(end);
                    }),
                    null);
            awaited(begun);
        }
    }

    private static List<String> awaited(CountDownLatch end) {
        try {
            end.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return List.of();
    }

    @Test
    void withoutAConnectionThePadLooksDisabledAndShowsWhy() {
        bot.loseLink();
        awaitHint("connection lost");
        assertThat(window.isEnabled("drive LEFT")).isFalse();
    }

    @Test
    void whileItDrivesThePadLooksUsable() {
        holdUp();
        window.await("the drive to be shown", () -> window.text("condition1").contains("driven by hand"));
        assertThat(window.isEnabled("drive LEFT")).isTrue();
    }

    private void awaitHint(String part) {
        window.await("the hint \"" + part + "\"", () -> window.text("driveHint").contains(part));
    }

    private void holdUp() {
        holdUp(AHEAD);
    }

    private void holdUp(String drive) {
        window.focus("drivePad");
        window.hold(KeyEvent.VK_UP);
        window.await("the robot to drive", () -> bot.told.contains(drive));
    }

    private void awaitStationary() {
        window.await(
                "the robot to stand", () -> bot.told.get(bot.told.size() - 1).equals("halt"));
        window.await("the hand to be off", () -> window.team.member(1).owner() == null);
    }
}
