package majicsim.pioneer.ranging;

import java.util.List;
import java.util.stream.IntStream;

/**
 * In which order the discs of each array fire, one of each array at a time. Immutable.
 *
 * @param discs disc numbers 0 to 31; those of one array fire in the order in which they stand here
 */
record PollingOrder(List<Integer> discs) {
    static final int ARRAYS = 4;

    private static final int DISCS = 32;
    private static final int DISCS_PER_ARRAY = 8;

    /** Every array from its first disc to its last. */
    static final PollingOrder USUAL =
            new PollingOrder(IntStream.range(0, DISCS).boxed().toList());

    /** Copies the list. */
    PollingOrder {
        discs = List.copyOf(discs);
    }

    /**
     * As POLLING has it: a byte for each disc, counted from 1; others are left out, and nothing at all means the usual
     * order.
     */
    static PollingOrder of(byte[] bytes) {
        List<Integer> discs = IntStream.range(0, bytes.length)
                .mapToObj(i -> (bytes[i] & 0xFF) - 1)
                .filter(disc -> disc >= 0 && disc < DISCS)
                .toList();
        return discs.isEmpty() ? USUAL : new PollingOrder(discs);
    }

    /** The discs of each array, in order; none for an array that must not fire. */
    List<List<Integer>> ofArrays() {
        return IntStream.range(0, ARRAYS).mapToObj(this::ofArray).toList();
    }

    private List<Integer> ofArray(int array) {
        return discs.stream().filter(disc -> disc / DISCS_PER_ARRAY == array).toList();
    }
}
