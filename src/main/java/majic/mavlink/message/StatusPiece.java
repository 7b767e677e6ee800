package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A STATUSTEXT, which may be a piece of a longer text. Immutable.
 *
 * @param severity 0 emergency to 7 debug
 * @param text up to 50 characters
 * @param id of a text of several pieces; 0 for one that is whole
 * @param piece its number in that text, from 0
 * @param isFull whether no zero byte ends it
 */
public record StatusPiece(int severity, String text, int id, int piece, boolean isFull) {
    private static final int LENGTH = 50;

    /** Reads the fields (MAVLink sheet 6). */
    public static StatusPiece of(Payload payload) {
        return new StatusPiece(
                payload.u8(0), payload.text(1, LENGTH), payload.u16(51), payload.u8(53), payload.u8(LENGTH) != 0);
    }

    /** Whether nothing of the text follows. */
    public boolean isLast() {
        return id == 0 || !isFull;
    }
}
