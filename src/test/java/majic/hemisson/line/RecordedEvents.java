package majic.hemisson.line;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Records the events of a conversation as text. */
final class RecordedEvents implements ConversationListener {
    private final List<String> all = new ArrayList<>();

    List<String> all() {
        return all;
    }

    @Override
    public void answered(Exchange exchange) {
        all.add("answered " + exchange.question().text());
    }

    @Override
    public void missed(Exchange exchange, boolean inMotion) {
        all.add("missed " + exchange.question().text() + (inMotion ? " in motion" : ""));
    }

    @Override
    public void wasReset() {
        all.add("reset");
    }

    @Override
    public void broken(IOException cause) {
        all.add("broken");
    }
}
