package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CountDownLatch;
import javax.swing.SwingUtilities;
import majic.gui.WindowWait;
import org.junit.jupiter.api.Test;

class EventThreadWatchTest {
    @Test
    void anEventThatWaitsIsFoundWithItsStack() throws Exception {
        EventThreadWatch watch = EventThreadWatch.start();
        CountDownLatch found = new CountDownLatch(1);
        SwingUtilities.invokeLater(() -> await(found));
        WindowWait.await("the stall to be found", watch::hasFound);
        found.countDown();
        assertThatThrownBy(watch::checkAndEnd).hasMessageContaining("EventThreadWatchTest");
    }

    @Test
    void eventsThatTakeTurnsAreFine() throws Exception {
        EventThreadWatch watch = EventThreadWatch.start();
        for (int event = 0; event < 200; event++) {
            SwingUtilities.invokeAndWait(() -> {});
        }
        watch.checkAndEnd();
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
