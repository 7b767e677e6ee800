package majicsim.aibo.urbi;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * The messages to one client (URBI sheet, section 2). While more than 1 MiB is unread, further messages are lost, whole
 * ones; before the next message that fits, a line reports the loss.
 */
final class SendBuffer {
    private static final int LIMIT = (1 << 20) - 1024;
    private static final int PACKET = 32 * 1024;

    private final @Nullable Line line;
    private final Supplier<String> lossReport;
    private final ByteArrayOutputStream packet = new ByteArrayOutputStream();
    private boolean lost;

    /**
     * @param line the client, or null for none
     * @param lossReport makes the line that reports a loss
     */
    SendBuffer(@Nullable Line line, Supplier<String> lossReport) {
        this.line = line;
        this.lossReport = lossReport;
    }

    /**
     * Adds a message to the next packet; the message is not created if no client can receive it.
     *
     * @param about how long it will be, in bytes
     */
    void write(long about, Supplier<String> message) {
        if (line == null || !line.isOpen()) {
            return;
        }
        int before = line.unsent() + packet.size();
        String text = before + about < LIMIT ? message.get() : "";
        boolean fits = !text.isEmpty() && before + text.length() < LIMIT;
        if (fits && lost) {
            put(lossReport.get());
        }
        if (fits) {
            put(text);
        }
        lost = !fits;
    }

    /** Sends the messages added since the last call. */
    void flush() {
        if (packet.size() > 0 && line != null && line.isOpen()) {
            line.send(packet.toByteArray());
        }
        packet.reset();
    }

    private void put(String text) {
        packet.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
        if (packet.size() > PACKET) {
            flush();
        }
    }
}
