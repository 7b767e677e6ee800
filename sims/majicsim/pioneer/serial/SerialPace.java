package majicsim.pioneer.serial;

import java.io.ByteArrayOutputStream;
import java.util.ArrayDeque;
import java.util.function.Consumer;

/** One direction of a serial line, which transmits bytes at the line's speed, ten bits a byte. */
final class SerialPace {
    /** The size of a controller's buffer; a message that does not fit is lost as a whole. */
    private static final int MOST_WAITING_BYTES = 512;

    private static final double BITS_A_BYTE = 10;

    private final ArrayDeque<Byte> waiting = new ArrayDeque<>();
    private final Consumer<byte[]> exit;
    private double bytesDue;

    SerialPace(Consumer<byte[]> exit) {
        this.exit = exit;
    }

    /** Returns whether there was room for them. */
    boolean enter(byte[] bytes) {
        if (waiting.size() + bytes.length > MOST_WAITING_BYTES) {
            return false;
        }
        for (byte b : bytes) {
            waiting.add(b);
        }
        return true;
    }

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    void step(long nanos, int bitsPerSecond) {
        if (waiting.isEmpty()) {
            bytesDue = 0;
            return;
        }
        bytesDue += nanos * 1e-9 * bitsPerSecond / BITS_A_BYTE;
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (; bytesDue >= 1 && !waiting.isEmpty(); bytesDue--) {
            out.write(waiting.remove());
        }
        if (out.size() > 0) {
            exit.accept(out.toByteArray());
        }
    }
}
