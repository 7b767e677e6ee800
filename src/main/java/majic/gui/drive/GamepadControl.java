package majic.gui.drive;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.gui.kit.EventThread;
import majic.team.Member;
import majic.text.ErrorWords;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Switches driving by a game controller on and off. Nothing is loaded before it is switched on. The controller is read
 * on a thread of its own, because that may block; the newest state drives the robots on the event dispatch thread. Must
 * be used on the event dispatch thread.
 */
public final class GamepadControl implements AutoCloseable {
    private static final Texts TEXTS = Texts.of(GamepadControl.class);

    private static final long PERIOD_MS = 40;

    private final Gamepad.Opener opener;
    private final Consumer<String> failed;
    private final GamepadDriver driver;
    private final AtomicReference<@Nullable GamepadState> newest = new AtomicReference<>();
    private @Nullable CountDownLatch end;

    /**
     * Creates a control that is switched off.
     *
     * @param opener opens the controller when it is switched on
     * @param guard whether the robots are guarded
     * @param failed receives the reason if it cannot be opened; on the event dispatch thread
     * @param errors receives the reason when a robot cannot be driven
     */
    public GamepadControl(Gamepad.Opener opener, GuardChoice guard, Consumer<String> failed, Consumer<String> errors) {
        this.opener = opener;
        this.failed = failed;
        this.driver = new GamepadDriver(guard, errors, () -> System.nanoTime() / 1_000_000);
    }

    /** Chooses the robots to drive; those driven at the moment stop. */
    public void choose(List<Member> members) {
        driver.choose(members);
    }

    public boolean isOn() {
        return end != null;
    }

    /** Switches on; returns at once. */
    public void switchOn() {
        if (end == null) {
            CountDownLatch newEnd = new CountDownLatch(1);
            end = newEnd;
            EventThread.background("game controller", () -> read(newEnd));
        }
    }

    /** Stops the robots that it drives, and closes the controller. */
    public void switchOff() {
        CountDownLatch last = end;
        end = null;
        driver.stop();
        if (last != null) {
            last.countDown();
        }
    }

    @Override
    public void close() {
        switchOff();
    }

    /** Reads until it is switched off; all calls of the controller are made by this thread. */
    private void read(CountDownLatch own) {
        try (Gamepad gamepad = opener.open()) {
            do {
                show(own, gamepad.read());
            } while (!own.await(PERIOD_MS, TimeUnit.MILLISECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (BotException e) {
            fail(own, String.valueOf(e.getMessage()));
        } catch (RuntimeException e) {
            fail(own, TEXTS.get("gamepad.lost", ErrorWords.of(String.valueOf(e.getMessage()))));
        }
    }

    private void fail(CountDownLatch own, String reason) {
        EventThread.later(() -> {
            if (end == own) {
                switchOff();
                failed.accept(reason);
            }
        });
    }

    /** Passes a state on; if the event thread is late, it receives only the newest. */
    private void show(CountDownLatch own, GamepadState state) {
        if (newest.getAndSet(state) == null) {
            EventThread.later(() -> {
                GamepadState now = newest.getAndSet(null);
                if (now != null && end == own) {
                    driver.drive(now);
                }
            });
        }
    }
}
