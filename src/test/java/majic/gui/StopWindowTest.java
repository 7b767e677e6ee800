package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JTextField;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import majic.gui.bots.RobotTab;
import majic.gui.map.TeamMap;
import majic.team.StopOrigin;
import majic.team.TeamListener;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("jdk")
class StopWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void theButtonHaltsEveryRobotAndLatches() {
        ToyBot one = window.add("one");
        ToyBot two = window.add("two");
        window.click("stop");
        window.await("both robots to halt", () -> one.told.contains("halt") && two.told.contains("halt"));
        assertThat(window.team.isLatched()).isTrue();
        window.await("the button to say so", () -> window.text("stopWord").equals("STOPPED"));
    }

    @Test
    void theButtonCountsTheRobotsThatHaveConfirmed() {
        window.add("one");
        window.add("two").confirmStops(false);
        window.click("stop");
        window.await("the count", () -> window.text("stopCount").equals("1 of 2 confirmed"));
    }

    @Test
    void aStopThatHasNotReachedOtherDesksDoesNotLookAsIfItHad() {
        window.add("one");
        window.click("stop");
        window.await("the count", () -> window.text("stopCount").equals("1 of 1 confirmed"));

        window.team.reportSharedStop("the broker refuses it");
        window.await("the restriction", () -> window.text("stopCount").equals("1 of 1, only here"));
        window.await("the strip", () -> window.text("stopReasons").equals("the broker refuses it"));
        assertThat(window.text("stopAlarm")).isEqualTo("STOP has not reached the robots of other desks");

        window.click("release");
        window.await(
                "the end",
                () -> !window.team.isLatched()
                        && window.team.stopStatus().elsewhere().isEmpty());
    }

    @Test
    void theTextsOfTheRedStripStayWhiteWhenTheLookChanges() {
        window.add("one");
        window.team.reportSharedStop("the broker refuses it");
        window.await("the strip", () -> !window.text("stopReasons").isEmpty());

        window.run(() -> SwingUtilities.updateComponentTreeUI(window.frame));
        assertThat(Stream.of("stopAlarm", "stopReasons", "stopRemedy").map(name -> window.find(name, Component.class)))
                .allMatch(text -> text.getForeground().equals(Color.WHITE));
    }

    @Test
    void theTipOfTheButtonNamesTheUserAndTheDeskOfAStopThatWasPressedElsewhere() {
        window.add("one");
        window.team.stopAll(new StopOrigin("Anna at desk1", null));
        window.await("the name", () -> tip().startsWith("STOP by Anna at desk1. Stops every robot"));

        window.click("release");
        window.await("the usual tip", () -> tip().startsWith("Stops every robot"));
    }

    private String tip() {
        return window.find("stop", JButton.class).getToolTipText();
    }

    @Test
    void aRobotThatDoesNotConfirmIsNamedBelowTheButtonUntilItConfirms() {
        window.add("one");
        ToyBot two = window.add("two");
        two.confirmStops(false);
        window.click("stop");
        window.await("the alarm", () -> window.isShowing("stopAlarm"));
        assertThat(window.text("stopAlarm")).isEqualTo("Stop not confirmed by robot 2");
        assertThat(window.text("stopReasons")).isEqualTo("2: takes no more data");
        window.click("release");
        assertThat(window.isShowing("stopAlarm")).isTrue();
        two.confirmStops(true);
        window.click("stopAgain");
        window.await("the alarm to go", () -> !window.isShowing("stopAlarm"));
    }

    @Test
    void f12ReachesARobotWhileTheLinkOfAnotherAndAListenerBlockAndNamesTheOther() {
        CountDownLatch testIsOver = new CountDownLatch(1);
        ToyBot one = window.add("one");
        ToyBot two = window.add("two");
        two.jam(testIsOver);
        window.team.addListener(mock(TeamListener.class, call -> {
            testIsOver.await();
            return null;
        }));

        window.press(KeyEvent.VK_F12);

        window.await("the name", () -> window.text("stopAlarm").equals("Stop not confirmed by robot 2"));
        assertThat(one.told).contains("halt");
        assertThat(two.told).doesNotContain("halt");
        testIsOver.countDown();
    }

    @Test
    void aRobotThatDoesNotConfirmItsOwnStopIsNamedOnItsPanelUntilItIsRemoved() {
        window.add("one").confirmStops(false);
        window.run(() -> window.team.stop(window.team.members(), null));
        window.await("the alarm", () -> window.isShowing("stopAlarm") && window.isShowing("stopProblem1"));
        assertThat(window.text("stopProblem1")).isEqualTo("Stop not confirmed, may still move: takes no more data");
        window.team.remove(1);
        window.await("the alarm to go", () -> !window.isShowing("stopAlarm"));
    }

    @Test
    void twentyFivePressesOfStopGiveOneLineWithACount() {
        window.add("one");
        window.add("two");
        window.add("three").confirmStops(false);
        for (int press = 0; press < 25; press++) {
            window.press(KeyEvent.VK_F12);
        }
        window.await("the count", () -> window.text("messages").contains("allows motion again (25 times)"));
        window.await(
                "the outcomes", () -> lines("1,2 stop: done") == 1 && lines("3 stop: failed: takes no more data") == 1);
        assertThat(lines("times)")).isEqualTo(1);
        assertThat(lines("STOP is latched")).isEqualTo(1);
        assertThat(lines("stop: ")).isEqualTo(2);
    }

    @Test
    void twentyFivePressesWithoutARobotGiveOneLineWithACount() {
        for (int press = 0; press < 25; press++) {
            window.press(KeyEvent.VK_F12);
        }
        window.await("the count", () -> window.text("messages").contains("(25 times)"));
        assertThat(lines("There is no robot to stop")).isEqualTo(1);
    }

    private long lines(String part) {
        return window.text("messages")
                .lines()
                .filter(line -> line.contains(part))
                .count();
    }

    @Test
    void stopAgainIsReachedByTabButAClickLeavesTheFocusWhereItIs() {
        JButton again = window.find("stopAgain", JButton.class);
        assertThat(again.isFocusable()).isTrue();
        assertThat(again.isRequestFocusEnabled()).isFalse();
    }

    @Test
    void nothingThatCanBeClickedMovesWhenTheAlarmAppearsOrGoes() {
        window.run(() -> window.frame.setSize(900, 600));
        window.add("one");
        ToyBot two = window.add("two");
        two.confirmStops(false);
        Map<Component, Rectangle> before = places();
        window.team.stop(window.team.members(), null);
        window.await("the alarm", () -> window.isShowing("stopAlarm"));
        window.run(window.frame::validate);
        assertThat(places()).containsAllEntriesOf(before);
        two.confirmStops(true);
        window.team.stop(window.team.members(), null);
        window.await("the alarm to go", () -> !window.isShowing("stopAlarm"));
        window.run(window.frame::validate);
        assertThat(places()).isEqualTo(before);
    }

    /** Returns where everything is on the screen that can be clicked. */
    private Map<Component, Rectangle> places() {
        Map<Component, Rectangle> places = new HashMap<>();
        window.run(() -> addPlaces(window.frame, places));
        return places;
    }

    private static void addPlaces(Component part, Map<Component, Rectangle> places) {
        boolean clickable = part instanceof AbstractButton
                || part instanceof JTextField
                || part instanceof TeamMap
                || part instanceof RobotTab;
        if (clickable && part.isShowing()) {
            places.put(part, new Rectangle(part.getLocationOnScreen(), part.getSize()));
        }
        if (part instanceof Container container) {
            Stream.of(container.getComponents()).forEach(child -> addPlaces(child, places));
        }
    }

    @Test
    void theAlarmNamesEveryRobotWithItsReasonInAsManyLinesAsNeeded() {
        window.run(() -> window.frame.setSize(700, 540));
        window.addAll(6);
        for (ToyBot toy : window.type.made) {
            toy.confirmStops(false);
        }
        window.team.stop(window.team.members(), null);
        window.await("the alarm", () -> window.text("stopReasons").startsWith("1–6: takes no more data"));
        Component reasons = window.find("stopReasons", Component.class);
        window.await("the whole text", () -> reasons.getHeight() >= reasons.getPreferredSize().height);
    }

    @Test
    void robotsWithTheSameReasonAreNamedTogether() {
        Map<Integer, String> unconfirmed =
                new TreeMap<>(Map.of(2, "silent", 3, "stuck", 7, "silent", 9, "lost", 11, "x"));
        assertThat(StopAlarm.reasons(unconfirmed)).isEqualTo("2, 7: silent   3: stuck   9: lost   11: x");
        unconfirmed.put(12, "y");
        assertThat(StopAlarm.reasons(unconfirmed)).endsWith("9: lost   11: x   12: y");
    }

    @Test
    void releaseAllowsMotionAgainAndHidesItself() {
        window.add("one");
        window.click("stop");
        window.click("release");
        assertThat(window.team.isLatched()).isFalse();
        window.await("the release button to go", () -> !window.isShowing("release"));
    }

    @Test
    void aLateEventDoesNotHideThatStopIsLatched() {
        window.add("one");
        window.click("stop");
        window.await("the button to say so", () -> window.text("stopWord").equals("STOPPED"));
        StopPanel panel = (StopPanel) window.find("stop", JButton.class).getParent();
        window.run(() -> panel.latchChanged(false));
        assertThat(window.text("stopWord")).isEqualTo("STOPPED");
    }

    @Test
    void escapeStopsWhileTheCommandLineHasTheFocus() {
        window.add("one");
        window.focus("commandLine");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void escapeClosesADialogWithoutStopping() {
        window.add("one");
        window.click("Add Bot");
        window.awaitDialog("Add Bot");
        window.focus("host");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the dialog to close", () -> !window.isShowing("Add Bot dialog"));
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void escapeStopsAgainAlthoughADialogHasOpenedByItselfMeanwhile() {
        window.add("one");
        window.focus("commandLine");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
        window.team.release();
        window.push("Add Bot");
        window.awaitDialogWithKeys("Add Bot");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
        window.await("the dialog to close", () -> !window.isShowing("Add Bot dialog"));
    }

    @Test
    void f12StopsWhileADialogHasTheFocus() {
        window.add("one");
        window.click("Add Bot");
        window.awaitDialog("Add Bot");
        window.focus("host");
        window.press(KeyEvent.VK_F12);
        window.await("the latch", window.team::isLatched);
        assertThat(window.isShowing("Add Bot dialog")).isTrue();
    }

    @Test
    void escapeClosesAMenuWithoutStoppingAndStopsTheNextTime() {
        window.add("one");
        window.run(() -> window.frame.getJMenuBar().getMenu(0).doClick());
        window.await("the menu", () -> MenuSelectionManager.defaultManager().getSelectedPath().length > 0);
        while (MenuSelectionManager.defaultManager().getSelectedPath().length > 0) {
            window.press(KeyEvent.VK_ESCAPE);
        }
        assertThat(window.team.isLatched()).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void escapeUnmarksAWrongLineWithoutStoppingAndStopsTheNextTime() {
        window.add("one");
        window.command("1 mvoe 5");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.text("hint")).startsWith("Up and Down");
        assertThat(window.text("commandLine")).isEqualTo("1 mvoe 5");
        assertThat(window.team.isLatched()).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void withoutARobotNothingLatchesAndTheMessageNamesTheReason() {
        window.click("stop");
        window.awaitMessage("There is no robot to stop");
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void theButtonShowsWhileTheKeysGoElsewhere() {
        window.await("the keys", () -> window.text("stopCount").equals("Esc or F12"));
        window.run(() -> window.frame.setExtendedState(Frame.ICONIFIED));
        window.await("the keys to go", () -> window.text("stopCount").equals("keys go elsewhere"));
        window.run(() -> {
            window.frame.setExtendedState(Frame.NORMAL);
            window.frame.toFront();
            window.frame.requestFocus();
        });
        window.await("the keys to return", () -> window.text("stopCount").equals("Esc or F12"));
    }

    @Test
    void theLatchedButtonShowsTheCountAndThatTheKeysGoElsewhere() {
        window.add("one");
        window.click("stop");
        window.await("the count", () -> window.text("stopCount").equals("1 of 1 confirmed"));
        window.run(() -> window.frame.setExtendedState(Frame.ICONIFIED));
        window.await("both", () -> window.text("stopCount").equals("1 of 1, keys elsewhere"));
    }

    @Test
    void theAccessibleNameOfTheLatchedButtonContainsTheCount() {
        window.add("one");
        window.click("stop");
        JButton stop = window.find("stop", JButton.class);
        window.await(
                "the count",
                () -> stop.getAccessibleContext()
                        .getAccessibleName()
                        .equals("Stopped, 1 of 1 confirmed; stop all robots again"));
    }

    @Test
    void f12StopsWhileTheCommandLineHasTheFocus() {
        window.add("one");
        window.focus("commandLine");
        window.press(KeyEvent.VK_F12);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void theButtonCanBeClickedWhileADialogIsOpen() {
        window.add("one");
        window.click("Help");
        Dialog help = window.awaitDialog("Help");
        window.run(() -> help.setLocation(0, 500));
        window.click("stop");
        window.await("the latch", window.team::isLatched);
    }
}
