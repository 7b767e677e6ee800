package majic.gui.completion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import javax.swing.JTextField;
import majic.script.help.Completion;
import majic.script.help.Completions;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;

class LineCompleterTest {
    private final CountDownLatch disk = new CountDownLatch(1);
    private final CompletableFuture<Thread> reader = new CompletableFuture<>();
    private final FocusedField field = GuiActionRunner.execute(FocusedField::new);
    private final SlowCompleter completer = GuiActionRunner.execute(SlowCompleter::new);

    @Test
    void namesThatAreReadInTheBackgroundAreShown() throws Exception {
        GuiActionRunner.execute(completer::edited);
        read();
        assertThat(completer.found).isEqualTo(1);
    }

    @Test
    void namesThatAreReadAfterTheListWasClosedAreDropped() throws Exception {
        GuiActionRunner.execute(() -> {
            completer.edited();
            completer.close();
        });
        read();
        assertThat(completer.found).isZero();
    }

    @Test
    void aChangeBeforeTheListWasClosedIsNotFollowedAfterIt() {
        GuiActionRunner.execute(() -> {
            completer.textChanged();
            completer.close();
        });
        GuiActionRunner.execute(() -> {});
        assertThat(completer.edits).isZero();
        GuiActionRunner.execute(completer::textChanged);
        GuiActionRunner.execute(() -> {});
        assertThat(completer.edits).isEqualTo(1);
    }

    /** Lets the disk answer, and waits until the event dispatch thread has handled the answer. */
    private void read() throws Exception {
        Thread reading = reader.get();
        disk.countDown();
        reading.join();
        GuiActionRunner.execute(() -> {});
    }

    private static final class FocusedField extends JTextField {
        private static final long serialVersionUID = 1L;

        FocusedField() {
            super("1 act W");
        }

        @Override
        public boolean isFocusOwner() {
            return true;
        }
    }

    /** Finds names on a disk that does not answer yet. */
    private final class SlowCompleter extends LineCompleter {
        private int edits;
        private int found;

        SlowCompleter() {
            super(field);
        }

        @Override
        protected Completions complete(LinePlace place) {
            reader.complete(Thread.currentThread());
            try {
                disk.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return new Completions(6, List.of(new Completion("Walk", "", "")));
        }

        @Override
        protected void edited() {
            edits++;
            find(names -> found++);
        }

        @Override
        protected void use(Completion entry) {}
    }
}
