package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class EventThreadTest {
    private final List<String> order = new CopyOnWriteArrayList<>();
    private final CountDownLatch ended = new CountDownLatch(1);

    @Test
    void anEventThatArrivesDuringAPieceIsHandledBeforeTheNextPiece() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            EventThread.piece(() -> {
                order.add("first piece");
                SwingUtilities.invokeLater(() -> order.add("key"));
            });
            EventThread.piece(() -> order.add("second piece"));
            EventThread.piece(ended::countDown);
        });
        ended.await();

        assertThat(order).containsExactly("first piece", "key", "second piece");
    }

    @Test
    void aPieceThatAPieceAddsRunsAfterThoseThatWait() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            EventThread.piece(() -> EventThread.piece(() -> {
                order.add("added");
                ended.countDown();
            }));
            EventThread.piece(() -> order.add("waiting"));
        });
        ended.await();

        assertThat(order).containsExactly("waiting", "added");
    }
}
