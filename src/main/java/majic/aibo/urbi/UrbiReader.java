package majic.aibo.urbi;

import java.util.ArrayList;
import java.util.List;
import majic.time.TimeSource;

/** Decodes one connection, and discards a binary that was cut short. Used by the connection's reader thread. */
final class UrbiReader {
    /**
     * A binary without progress for so long may be cut short, seconds; less than the silence at which a walking dog is
     * stopped.
     */
    private static final double STALLED_S = 1;

    private final TimeSource time;
    private final UrbiDecoder decoder = new UrbiDecoder();
    private boolean waiting;
    private long sinceNanos;

    UrbiReader(TimeSource time) {
        this.time = time;
    }

    /** Decodes the first {@code count} bytes of a chunk and returns the messages that are complete now. */
    List<UrbiMessage> read(byte[] chunk, int count) {
        List<UrbiMessage> messages = new ArrayList<>(decoder.feed(chunk, count));
        boolean sameBinary = waiting && decoder.isInBinary() && messages.isEmpty();
        if (!sameBinary) {
            waiting = decoder.isInBinary();
            sinceNanos = time.nanos();
        } else if (time.secondsSince(sinceNanos) > STALLED_S) {
            messages.addAll(decoder.giveUpCutBinary());
            sinceNanos = time.nanos();
        }
        return messages;
    }
}
