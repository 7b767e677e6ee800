package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;

class RefreshTicksTest {
    private final AtomicInteger updates = new AtomicInteger();

    @Test
    void anUpdateRunsOnceHoweverOftenItBecomesDueBeforeATick() throws Exception {
        CountDownLatch last = new CountDownLatch(1);
        Runnable update = updates::incrementAndGet;
        SwingUtilities.invokeAndWait(() -> {
            RefreshTicks.once(update);
            RefreshTicks.once(update);
            RefreshTicks.once(last::countDown);
        });

        await(last);
        SwingUtilities.invokeAndWait(() -> {});
        assertThat(updates).hasValue(1);
    }

    @Test
    void anUpdateThatBecomesDueDuringATickRunsAtTheNextOne() throws Exception {
        CountDownLatch thrice = new CountDownLatch(3);
        RefreshTicks.once(new Runnable() {
            @Override
            public void run() {
                thrice.countDown();
                if (thrice.getCount() > 0) {
                    RefreshTicks.once(this);
                }
            }
        });

        await(thrice);
    }

    @Test
    void aRepeatedUpdateRunsUntilItIsRemoved() throws Exception {
        CountDownLatch twice = new CountDownLatch(2);
        Runnable update = twice::countDown;
        SwingUtilities.invokeAndWait(() -> RefreshTicks.add(update));
        await(twice);

        Runnable counted = updates::incrementAndGet;
        CountDownLatch later = new CountDownLatch(1);
        SwingUtilities.invokeAndWait(() -> {
            RefreshTicks.remove(update);
            RefreshTicks.add(counted);
            RefreshTicks.remove(counted);
            RefreshTicks.once(later::countDown);
        });
        await(later);
        assertThat(updates).hasValue(0);
    }

    @Test
    void anUpdateThatFailsDelaysNoOther() throws Exception {
        assertThat(reportedWhile(() -> {
                    throw new IllegalStateException("an update that fails");
                }))
                .isInstanceOf(IllegalStateException.class);
    }

    @Test
    void anUpdateThatFailsWithAnErrorDelaysNoOther() throws Exception {
        assertThat(reportedWhile(() -> {
                    throw new NoClassDefFoundError("a class of a plug-in");
                }))
                .isInstanceOf(NoClassDefFoundError.class);
    }

    /** Returns what is reported for an update that fails; another update must run at the same tick. */
    private static Throwable reportedWhile(Runnable failing) throws Exception {
        AtomicReference<Throwable> reported = new AtomicReference<>();
        CountDownLatch other = new CountDownLatch(1);
        SwingUtilities.invokeAndWait(() -> {
            Thread thread = Thread.currentThread();
            thread.setUncaughtExceptionHandler((where, problem) -> reported.set(problem));
            RefreshTicks.add(failing);
            RefreshTicks.once(() -> {
                RefreshTicks.remove(failing);
                thread.setUncaughtExceptionHandler(null);
                other.countDown();
            });
        });

        await(other);
        return reported.get();
    }

    private static void await(CountDownLatch latch) {
        WaitLimit.await("the updates", latch);
    }
}
