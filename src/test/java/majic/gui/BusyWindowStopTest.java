package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JButton;
import javax.swing.SwingUtilities;
import majic.team.Member;
import majic.team.TeamListener;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** F12 while the event dispatch thread is kept by one event, as by a disk that does not answer. */
class BusyWindowStopTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final List<String> events = new CopyOnWriteArrayList<>();
    private final Robot keyboard;

    BusyWindowStopTest() throws AWTException {
        keyboard = new Robot();
    }

    @BeforeEach
    void record() {
        window.team.addListener(new TeamListener() {
            @Override
            public void stopped(Collection<Member> robots, long atNanos) {
                events.add("stopped");
            }

            @Override
            public void latchChanged(boolean then) {
                events.add(then ? "latched" : "released");
            }
        });
        window.focus("commandLine");
    }

    /** Presses and releases a key without waiting for the event dispatch thread. */
    private void press(int key) {
        keyboard.keyPress(key);
        keyboard.keyRelease(key);
    }

    private void awaitIdle() {
        keyboard.waitForIdle();
    }

    private int count(String event) {
        return Collections.frequency(events, event);
    }

    @Test
    void f12StopsWhileTheEventThreadIsBusyAndOnlyOnce() throws Exception {
        ToyBot one = window.add("one");
        try (BusyEventThread busy = BusyEventThread.begin()) {
            press(KeyEvent.VK_F12);
            window.await("the stop", () -> one.told.contains("halt") && count("stopped") == 1);
            assertThat(busy.isBusy()).isTrue();
        }
        window.await("the button to say so", () -> window.text("stopWord").equals("STOPPED"));
        awaitIdle();
        assertThat(events).containsOnlyOnce("stopped", "latched").doesNotContain("released");
    }

    @Test
    void f12StopsBehindOtherKeysWhichAreTypedAfterwards() throws Exception {
        ToyBot one = window.add("one");
        try (BusyEventThread busy = BusyEventThread.begin()) {
            List.of(KeyEvent.VK_B, KeyEvent.VK_O, KeyEvent.VK_T).forEach(this::press);
            press(KeyEvent.VK_F12);
            press(KeyEvent.VK_S);
            window.await("the stop", () -> one.told.contains("halt"));
            assertThat(busy.isBusy()).isTrue();
        }
        window.await("the keys", () -> window.text("commandLine").equals("bots"));
    }

    @Test
    void eachPressStops() throws Exception {
        window.add("one");
        try (BusyEventThread busy = BusyEventThread.begin()) {
            for (int presses = 1; presses <= 3; presses++) {
                int wanted = presses;
                press(KeyEvent.VK_F12);
                window.await("stop " + presses, () -> count("stopped") == wanted);
            }
            assertThat(busy.isBusy()).isTrue();
        }
        awaitIdle();
        assertThat(count("stopped")).isEqualTo(3);
    }

    @Test
    void f12StopsWhileADialogHasTheFocus() throws Exception {
        ToyBot one = window.add("one");
        window.click("Add Bot");
        window.awaitDialogWithKeys("Add Bot");
        try (BusyEventThread busy = BusyEventThread.begin()) {
            press(KeyEvent.VK_F12);
            window.await("the stop", () -> one.told.contains("halt"));
            assertThat(busy.isBusy()).isTrue();
        }
        awaitIdle();
        assertThat(window.isShowing("Add Bot dialog")).isTrue();
        assertThat(count("stopped")).isEqualTo(1);
    }

    @Test
    void f12StopsWhileAMenuIsOpen() throws Exception {
        ToyBot one = window.add("one");
        window.run(() -> window.frame.getJMenuBar().getMenu(0).doClick());
        try (BusyEventThread busy = BusyEventThread.begin()) {
            press(KeyEvent.VK_F12);
            window.await("the stop", () -> one.told.contains("halt"));
            assertThat(busy.isBusy()).isTrue();
        }
        awaitIdle();
        assertThat(count("stopped")).isEqualTo(1);
    }

    @Test
    void aReleaseFromBeforeTheKeyDoesNotUndoTheStop() throws Exception {
        window.add("one");
        window.click("stop");
        window.await("the latch", window.team::isLatched);
        JButton release = window.find("release", JButton.class);
        try (BusyEventThread busy = BusyEventThread.begin()) {
            SwingUtilities.invokeLater(release::doClick);
            press(KeyEvent.VK_F12);
            window.await("the second stop", () -> count("stopped") == 2);
            assertThat(busy.isBusy()).isTrue();
        }
        window.await("the release", () -> count("released") == 1);
        window.await("the stop after it", () -> count("stopped") == 3);
        assertThat(window.team.isLatched()).isTrue();
    }

    @Test
    void otherKeysDoNotStopEarlyAndEscStopsInItsTurn() throws Exception {
        window.add("one");
        try (BusyEventThread busy = BusyEventThread.begin()) {
            List.of(KeyEvent.VK_F11, KeyEvent.VK_A, KeyEvent.VK_ESCAPE, KeyEvent.VK_F12)
                    .forEach(this::press);
            window.await("the stop by F12", () -> !events.isEmpty());
            assertThat(busy.isBusy()).isTrue();
            assertThat(count("stopped")).isLessThan(2);
        }
        window.await("the stop by Esc", () -> count("stopped") == 2);
        awaitIdle();
        assertThat(count("stopped")).isEqualTo(2);
    }

    @Test
    void withoutARobotTheMessageFollowsWhenTheEventThreadIsFree() throws Exception {
        try (BusyEventThread busy = BusyEventThread.begin()) {
            press(KeyEvent.VK_F12);
            assertThat(busy.isBusy()).isTrue();
        }
        window.awaitMessage("There is no robot to stop");
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void eventsKeepTheirOrder() throws Exception {
        window.add("one");
        List<Integer> order = Collections.synchronizedList(new ArrayList<>());
        try (BusyEventThread busy = BusyEventThread.begin()) {
            for (int number = 0; number < 100; number++) {
                int place = number;
                SwingUtilities.invokeLater(() -> order.add(place));
                if (number % 20 == 0) {
                    press(KeyEvent.VK_F12);
                    window.await("a stop", () -> count("stopped") == place / 20 + 1);
                }
            }
            assertThat(busy.isBusy()).isTrue();
        }
        window.await("all", () -> order.size() == 100);
        assertThat(order).isSorted();
    }
}
