package majic.gui;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.log.Line;
import majic.log.SessionListener;
import majic.script.MajicParser;
import majic.script.Session;

/** Runs a line as if it had been typed, and waits for its end. */
final class AwaitedLine implements SessionListener {
    private final MajicParser parser;
    private final List<String> errors = new CopyOnWriteArrayList<>();

    private AwaitedLine(MajicParser parser) {
        this.parser = parser;
    }

    /**
     * Runs a line; blocks until it and all it began have ended.
     *
     * @return why it failed; empty if it did not
     */
    static Optional<String> run(Session session, String line) {
        MajicParser parser = MajicParser.prompt(session);
        AwaitedLine awaited = new AwaitedLine(parser);
        session.addListener(awaited);
        try {
            parser.parseText(line);
            parser.awaitAll();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            session.removeListener(awaited);
        }
        return awaited.errors.stream().findFirst();
    }

    @Override
    public void line(Line line) {
        boolean failed = line.kind() == Line.Kind.ERROR || line.kind() == Line.Kind.FAILURE;
        if (failed && line.asker() == parser) {
            errors.add(line.text());
        }
    }
}
