package majic.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class WaitPolicyTest {
    private final List<String> seen = new ArrayList<>();

    private void note() {
        seen.add((WaitPolicy.isAllowed() ? "waits" : "no wait") + (WaitPolicy.isObserving() ? ", observes" : ""));
    }

    @Test
    void aThreadThatObservesDoesNotWait() {
        WaitPolicy.observing(this::note);
        WaitPolicy.without(this::note);
        note();
        assertThat(seen).containsExactly("no wait, observes", "no wait", "waits");
    }

    @Test
    void whatFailsWhileObservingLeavesNoTrace() {
        try {
            WaitPolicy.observing(() -> {
                throw new IllegalStateException("a driver failed");
            });
        } catch (IllegalStateException e) {
            note();
        }
        assertThat(seen).containsExactly("waits");
    }
}
