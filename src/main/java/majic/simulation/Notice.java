package majic.simulation;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Passes one sentence on, as soon as there is both the sentence and a listener. Thread-safe. */
final class Notice implements Consumer<String> {
    private @Nullable String text;
    private @Nullable Consumer<String> listener;

    @Override
    public synchronized void accept(String sentence) {
        text = sentence;
        deliver();
    }

    synchronized void deliverTo(Consumer<String> newListener) {
        listener = newListener;
        deliver();
    }

    private void deliver() {
        if (listener != null && text != null) {
            listener.accept(text);
        }
    }
}
