package majic.mavlink.frame;

/**
 * The sequence numbers of one sender, from 0 to 255 and again. A number that is less than 128 ahead of the newest one
 * shows how many frames are missing. A frame that is repeated is not missing, and one that was overtaken by a few
 * others is missing only until it arrives. For one thread.
 */
final class SequenceNumbers {
    private static final int NUMBERS = 256;

    /** A number that is farther behind is not that of a late frame: the sender counts anew. */
    private static final int LATE = Integer.SIZE;

    private int newest;

    /** Bit k is set if the frame with the number k before the newest one is not missing. */
    private int arrived = -1;

    /** Begins with the first frame. */
    SequenceNumbers(int first) {
        this.newest = first;
    }

    /**
     * Takes the number of the next frame.
     *
     * @return how many frames more than before are missing; -1 if a missing one has arrived
     */
    int take(int number) {
        int ahead = Math.floorMod(number - newest, NUMBERS);
        if (ahead == 0) {
            return 0;
        }
        if (ahead < NUMBERS / 2) {
            newest = number;
            arrived = ahead < LATE ? arrived << ahead | 1 : 1;
            return ahead - 1;
        }
        int behind = NUMBERS - ahead;
        if (behind >= LATE) {
            newest = number;
            arrived = -1;
            return 0;
        }
        boolean missed = (arrived & 1 << behind) == 0;
        arrived |= 1 << behind;
        return missed ? -1 : 0;
    }
}
