package majic.hemisson;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import java.util.stream.IntStream;
import majic.hemisson.line.Conversation;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Records what a Hemisson's driver sends and receives, with the times of the lab's clock, from its log. */
final class HemissonWire extends Handler implements AutoCloseable {
    /** One command or one reply, without its line end. */
    record Said(long nanos, boolean byDriver, String text) {}

    /** A command and its reply. */
    record Exchange(Said command, Said answer) {
        /** Returns the transmission time of both at 88 µs a character, line ends included, ms. */
        double lineMs() {
            return (command.text().length() + 1 + answer.text().length() + 2) * 0.088;
        }
    }

    private static final SimpleFormatter MESSAGES = new SimpleFormatter();

    private final Logger logger = Logger.getLogger(Conversation.class.getName());
    private final @Nullable Level before = logger.getLevel();
    private final List<Said> all = new CopyOnWriteArrayList<>();
    private final TimeSource time;

    HemissonWire(TimeSource time) {
        this.time = time;
        logger.setLevel(Level.FINER);
        logger.setUseParentHandlers(false);
        logger.addHandler(this);
    }

    /** Returns the exchanges from the first command with a prefix to the first stop after it, both included. */
    List<Said> motion(String begin) {
        List<Said> said = List.copyOf(all);
        int from = first(said, 0, begin);
        return said.subList(from, first(said, from, "D,0,0") + 1);
    }

    /** Returns what the driver sent from the first occurrence of a command on. */
    List<Said> commandsSinceFirst(String text) {
        return all.stream()
                .filter(Said::byDriver)
                .dropWhile(said -> !said.text().equals(text))
                .toList();
    }

    /** Returns what the driver sent from a time on. */
    List<Said> commandsSince(long nanos) {
        return all.stream()
                .filter(said -> said.byDriver() && said.nanos() >= nanos)
                .toList();
    }

    static List<Exchange> exchanges(List<Said> said) {
        return IntStream.range(0, said.size() - 1)
                .filter(at -> said.get(at).byDriver() && !said.get(at + 1).byDriver())
                .mapToObj(at -> new Exchange(said.get(at), said.get(at + 1)))
                .toList();
    }

    private static int first(List<Said> said, int from, String begin) {
        return IntStream.range(from, said.size())
                .filter(at -> said.get(at).byDriver() && said.get(at).text().startsWith(begin))
                .findFirst()
                .orElseThrow();
    }

    @Override
    public void publish(LogRecord written) {
        String line = MESSAGES.formatMessage(written);
        if (line.startsWith("> ") || line.startsWith("< ")) {
            all.add(new Said(time.nanos(), line.startsWith(">"), line.substring(2)));
        }
    }

    @Override
    public void flush() {
        // nothing is kept back
    }

    @Override
    public void close() {
        logger.removeHandler(this);
        logger.setLevel(before);
        logger.setUseParentHandlers(true);
    }
}
