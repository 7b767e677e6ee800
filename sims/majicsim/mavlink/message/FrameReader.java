package majicsim.mavlink.message;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Finds the frames in what arrives on one link, in pieces of any size. Skips text, messages that are not known here,
 * and frames with incompatible flags; behind a wrong checksum it looks again one byte later. Signatures are not
 * checked. Not thread-safe.
 */
public final class FrameReader {
    private static final int FLAG_SIGNED = 1;

    private byte[] pending = {};
    private int damaged;

    /**
     * Reads what has arrived.
     *
     * @param bytes as they came
     * @return the frames that are complete now, in order
     */
    public List<Frame> feed(byte[] bytes) {
        int before = pending.length;
        pending = Arrays.copyOf(pending, before + bytes.length);
        System.arraycopy(bytes, 0, pending, before, bytes.length);
        List<Frame> frames = new ArrayList<>();
        int start = 0;
        while (start < pending.length) {
            int length = lengthAt(start);
            if (length > pending.length - start) {
                break;
            }
            start += length == 0 ? 1 : taken(start, length, frames);
        }
        pending = Arrays.copyOfRange(pending, start, pending.length);
        return frames;
    }

    /**
     * How many start bytes were followed by a wrong checksum.
     *
     * @return since the reader was made
     */
    public int damaged() {
        return damaged;
    }

    /** How long the frame that starts here is; 0 if none does, and much if that is not known yet. */
    private int lengthAt(int start) {
        int magic = octet(start);
        if (magic != Frame.MAGIC_V1 && magic != Frame.MAGIC_V2) {
            return 0;
        }
        boolean isV1 = magic == Frame.MAGIC_V1;
        int header = isV1 ? Frame.HEADER_V1 : Frame.HEADER_V2;
        if (pending.length - start < header) {
            return Integer.MAX_VALUE;
        }
        boolean isSigned = !isV1 && (octet(start + 2) & FLAG_SIGNED) != 0;
        return header + octet(start + 1) + Frame.CHECKSUM + (isSigned ? Frame.SIGNATURE : 0);
    }

    /** Adds the frame if it is good, and returns how many bytes are done. */
    private int taken(int start, int length, List<Frame> frames) {
        boolean isV1 = octet(start) == Frame.MAGIC_V1;
        MessageType type = MessageType.of(idAt(start, isV1));
        boolean isIncompatible = !isV1 && (octet(start + 2) & ~FLAG_SIGNED) != 0;
        if (type == null || isIncompatible) {
            return length;
        }
        Frame frame = decoded(start, isV1, type);
        if (frame == null) {
            damaged++;
            return 1;
        }
        frames.add(frame);
        return length;
    }

    private @Nullable Frame decoded(int start, boolean isV1, MessageType type) {
        int from = start + (isV1 ? Frame.HEADER_V1 : Frame.HEADER_V2);
        int end = from + octet(start + 1);
        int checksum =
                new Checksum().add(pending, start + 1, end).add(type.crcExtra()).value();
        if (checksum != (octet(end) | octet(end + 1) << 8)) {
            return null;
        }
        Message message = new Message(type, Arrays.copyOfRange(pending, from, end));
        return isV1
                ? new Frame(1, octet(start + 2), octet(start + 3), octet(start + 4), message)
                : new Frame(2, octet(start + 4), octet(start + 5), octet(start + 6), message);
    }

    private int idAt(int start, boolean isV1) {
        return isV1 ? octet(start + 5) : octet(start + 7) | octet(start + 8) << 8 | octet(start + 9) << 16;
    }

    private int octet(int index) {
        return pending[index] & 0xFF;
    }
}
