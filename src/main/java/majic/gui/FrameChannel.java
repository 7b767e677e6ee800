package majic.gui;

import java.util.Optional;
import java.util.function.Consumer;
import majic.gui.command.MessageArea;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.log.Line;
import majic.script.MajicParser;
import majic.script.Session;
import majic.text.ErrorWords;

/** Passes the lines of the window's parts to the parser, and their messages to the message area. */
final class FrameChannel implements CommandChannel {
    private final Session session;
    private final MajicParser parser;
    private final MessageArea messages;

    FrameChannel(Session session, MajicParser parser, MessageArea messages) {
        this.session = session;
        this.parser = parser;
        this.messages = messages;
    }

    @Override
    public void submit(String lines) {
        EventThread.background("giving a line", () -> parser.parseText(lines));
    }

    @Override
    public void submit(String line, Consumer<Optional<String>> ended) {
        EventThread.background("giving a line", () -> {
            Optional<String> wrong = parser.mistake(line).or(() -> parser.parseText(line));
            EventThread.later(() -> ended.accept(wrong));
        });
    }

    @Override
    public void showError(String sentence) {
        session.log().write("error", sentence);
        messages.line(new Line(Line.Kind.ERROR, ErrorWords.of(sentence)));
    }

    /** Shows a message that reports no error; callable from any thread. */
    void showNotice(String sentence) {
        messages.line(new Line(Line.Kind.NOTICE, sentence));
    }
}
