package majic.text;

import java.util.ArrayList;
import java.util.List;

/** Lists numbers in few characters. */
public final class NumberList {
    /** From as many consecutive numbers on, only the first and the last are listed. */
    private static final int SHORTEST_RANGE = 4;

    private NumberList() {}

    /**
     * Lists numbers; four or more that follow each other as a range.
     *
     * @param numbers in increasing order, each once
     * @return for instance {@code 1–12, 14, 15}
     */
    public static String of(List<Integer> numbers) {
        List<String> parts = new ArrayList<>();
        int begin = 0;
        while (begin < numbers.size()) {
            int end = begin + 1;
            while (end < numbers.size() && numbers.get(end) == numbers.get(end - 1) + 1) {
                end++;
            }
            if (end - begin < SHORTEST_RANGE) {
                numbers.subList(begin, end).forEach(number -> parts.add("" + number));
            } else {
                parts.add(numbers.get(begin) + "–" + numbers.get(end - 1));
            }
            begin = end;
        }
        return String.join(", ", parts);
    }
}
