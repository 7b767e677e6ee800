package majic.mavlink.session;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import majic.mavlink.message.StatusPiece;
import majic.mavlink.message.StatusText;
import majic.time.TimeSource;

/** The texts of an autopilot: joins their pieces and passes those that matter on to the user. Thread-safe. */
public final class StatusTexts {
    private static final int KEPT = 50;
    private static final int LONGEST = 1000;

    /** The same text is not shown again for this time: refusals to arm are repeated every 30 s. */
    private static final double REPEATED_S = 120;

    private final TimeSource time;
    private final Consumer<String> notices;
    private final Predicate<String> expected;
    private final Deque<StatusText> texts = new ArrayDeque<>();
    private final StringBuilder pieces = new StringBuilder();
    private int joined;

    StatusTexts(TimeSource time, Consumer<String> notices, Predicate<String> expected) {
        this.time = time;
        this.notices = notices;
        this.expected = expected;
    }

    /**
     * Takes a piece; on the reader thread.
     *
     * @return the whole text, if this was its last piece; otherwise empty
     */
    String take(StatusPiece piece) {
        String whole = join(piece);
        if (!whole.isBlank() && add(new StatusText(piece.severity(), whole, time.nanos())) && !expected.test(whole)) {
            notices.accept("the autopilot reports: " + whole);
        }
        return whole;
    }

    private synchronized String join(StatusPiece piece) {
        if (piece.id() != joined || piece.piece() == 0 || pieces.length() > LONGEST) {
            pieces.setLength(0);
        }
        joined = piece.id();
        pieces.append(piece.text());
        if (!piece.isLast()) {
            return "";
        }
        String whole = pieces.toString().strip();
        pieces.setLength(0);
        return whole;
    }

    /** Returns whether the user should see it. */
    private synchronized boolean add(StatusText text) {
        boolean known = texts.stream()
                .anyMatch(old -> old.text().equals(text.text()) && time.secondsSince(old.atNanos()) < REPEATED_S);
        texts.addLast(text);
        if (texts.size() > KEPT) {
            texts.removeFirst();
        }
        return text.isWarning() && !known;
    }

    /** Returns the newest text; empty before the first. */
    public synchronized String newest() {
        return texts.isEmpty() ? "" : texts.getLast().text();
    }

    /** Returns the texts, the oldest first, at most 50. */
    public synchronized List<StatusText> all() {
        return List.copyOf(texts);
    }

    /**
     * Returns the warnings since a time, each once, behind a colon.
     *
     * @param nanos on the driver's clock
     * @return {@code ": Arm: Accels inconsistent; Arm: AHRS: waiting for home"}; empty if there are none
     */
    public synchronized String reasonsSince(long nanos) {
        List<String> reasons = texts.stream()
                .filter(text -> text.isWarning() && text.atNanos() >= nanos)
                .map(StatusText::text)
                .distinct()
                .toList();
        return reasons.isEmpty() ? "" : reasons.stream().collect(Collectors.joining("; ", ": ", ""));
    }
}
