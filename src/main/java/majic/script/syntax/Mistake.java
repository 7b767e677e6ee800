package majic.script.syntax;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import majic.text.VisibleText;

/**
 * Something wrong in a script. Immutable.
 *
 * @param line where, counted from 1
 * @param column where, counted from 1
 * @param message what is wrong and what would be right
 */
public record Mistake(int line, int column, String message) {
    private static final int MOST_LISTED = 20;

    /** Shows control characters of the script as text. */
    public Mistake {
        message = VisibleText.of(message);
    }

    public String in(String file) {
        return file + ":" + line + ":" + column + ": " + message;
    }

    /** A line for each of the first mistakes in a file, in their order, and one for all others. */
    public static List<String> inOrder(List<Mistake> mistakes, String file) {
        List<String> listed = new ArrayList<>(mistakes.stream()
                .sorted(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column))
                .limit(MOST_LISTED)
                .map(mistake -> mistake.in(file))
                .toList());
        int more = mistakes.size() - MOST_LISTED;
        if (more > 0) {
            listed.add(file + ": and " + counted(more).replaceFirst(" ", " more "));
        }
        return listed;
    }

    /** As in "1 mistake", "3 mistakes". */
    public static String counted(int mistakes) {
        return mistakes == 1 ? "1 mistake" : mistakes + " mistakes";
    }
}
