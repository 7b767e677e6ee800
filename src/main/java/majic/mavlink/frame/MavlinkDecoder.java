package majic.mavlink.frame;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Makes frames of the bytes from one peer, and counts what is lost or damaged. After a wrong checksum it looks for the
 * next frame from the second byte on, so that a good frame inside the bad one is not lost. A frame of an unknown
 * message cannot be checked: it is skipped, unless the byte before it belonged to no frame. For one thread;
 * {@link #counts} is for any.
 */
public final class MavlinkDecoder {
    private static final int LONGEST = MavlinkEncoder.HEADER_2 + 255 + MavlinkEncoder.CRC_LENGTH + 13;
    private static final int SIGNED = 1;
    private static final int SIGNATURE_LENGTH = 13;

    private final byte[] buffer = new byte[2 * LONGEST];
    private final Map<Integer, SequenceNumbers> senders = new HashMap<>();
    private int filled;
    private int start;
    private boolean inStep = true;
    private volatile FrameCounts counts = FrameCounts.NONE;

    /** Begins before the first byte. */
    public MavlinkDecoder() {}

    /**
     * Takes bytes; keeps an incomplete frame for the next call.
     *
     * @param bytes from index 0 on
     * @param count how many of them
     * @param frames receives each whole frame of a known message, in order
     */
    public void decode(byte[] bytes, int count, Consumer<MavlinkFrame> frames) {
        int taken = 0;
        while (taken < count) {
            int room = Math.min(buffer.length - filled, count - taken);
            System.arraycopy(bytes, taken, buffer, filled, room);
            filled += room;
            taken += room;
            takeFrames(frames);
            System.arraycopy(buffer, start, buffer, 0, filled - start);
            filled -= start;
            start = 0;
        }
    }

    /**
     * Returns what has arrived so far.
     *
     * @return a snapshot
     */
    public FrameCounts counts() {
        return counts;
    }

    private void takeFrames(Consumer<MavlinkFrame> frames) {
        int length = nextLength();
        while (length > 0 && start + length <= filled) {
            take(length, frames);
            length = nextLength();
        }
    }

    /** The length of the frame at the next start byte, whose header has arrived; 0 if more bytes are needed. */
    private int nextLength() {
        while (start < filled) {
            int first = buffer[start] & 0xFF;
            int left = filled - start;
            if (first == MavlinkEncoder.START_1) {
                return left < 2 ? 0 : MavlinkEncoder.HEADER_1 + at(1) + MavlinkEncoder.CRC_LENGTH;
            }
            if (first == MavlinkEncoder.START_2) {
                if (left < 3) {
                    return 0;
                }
                int flags = at(2);
                if ((flags & ~SIGNED) == 0) {
                    int signature = flags == SIGNED ? SIGNATURE_LENGTH : 0;
                    return MavlinkEncoder.HEADER_2 + at(1) + MavlinkEncoder.CRC_LENGTH + signature;
                }
            }
            skip();
        }
        return 0;
    }

    private void take(int length, Consumer<MavlinkFrame> frames) {
        boolean second = at(0) == MavlinkEncoder.START_2;
        int header = second ? MavlinkEncoder.HEADER_2 : MavlinkEncoder.HEADER_1;
        int id = second ? at(7) | at(8) << 8 | at(9) << 16 : at(5);
        Optional<MavlinkMessageType> type = MavlinkMessageType.of(id);
        if (type.isEmpty()) {
            takeUnknown(length, second);
            return;
        }
        int end = start + header + at(1);
        int crc = X25.of(buffer, start + 1, end, type.get().crcExtra());
        if ((buffer[end] & 0xFF) != (crc & 0xFF) || (buffer[end + 1] & 0xFF) != crc >>> 8) {
            counts = new FrameCounts(counts.frames(), counts.lost(), counts.damaged() + 1, counts.skipped());
            skip();
            return;
        }
        byte[] payload = Arrays.copyOfRange(buffer, start + header, end);
        MavlinkFrame frame = new MavlinkFrame(
                second ? 2 : 1,
                at(second ? 4 : 2),
                at(second ? 5 : 3),
                at(second ? 6 : 4),
                type.get(),
                new Payload(payload, type.get().fullLength()));
        count(frame.sequence(), frame.system(), frame.component());
        pass(length);
        frames.accept(frame);
    }

    /** Behind a byte that belonged to no frame this may be no frame either. */
    private void takeUnknown(int length, boolean second) {
        if (inStep) {
            count(at(second ? 4 : 2), at(second ? 5 : 3), at(second ? 6 : 4));
            pass(length);
        } else {
            skip();
        }
    }

    private void count(int sequence, int system, int component) {
        SequenceNumbers sender = senders.get(system << 8 | component);
        int missing = 0;
        if (sender == null) {
            senders.put(system << 8 | component, new SequenceNumbers(sequence));
        } else {
            missing = sender.take(sequence);
        }
        counts = new FrameCounts(counts.frames() + 1, counts.lost() + missing, counts.damaged(), counts.skipped());
    }

    private void pass(int length) {
        start += length;
        inStep = true;
    }

    private void skip() {
        start++;
        inStep = false;
        counts = new FrameCounts(counts.frames(), counts.lost(), counts.damaged(), counts.skipped() + 1);
    }

    private int at(int index) {
        return buffer[start + index] & 0xFF;
    }
}
