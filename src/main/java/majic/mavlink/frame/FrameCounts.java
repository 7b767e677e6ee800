package majic.mavlink.frame;

/**
 * What has arrived from one peer. Immutable.
 *
 * @param frames whole frames, those of unknown messages included
 * @param lost frames that are missing by the sequence numbers of their senders
 * @param damaged frames whose checksum was wrong
 * @param skipped bytes that belonged to no frame, such as the text that an autopilot sends first
 */
public record FrameCounts(long frames, long lost, long damaged, long skipped) {
    /** Before the first byte. */
    public static final FrameCounts NONE = new FrameCounts(0, 0, 0, 0);
}
