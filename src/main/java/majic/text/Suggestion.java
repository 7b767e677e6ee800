package majic.text;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds the word that was probably meant by a mistyped one. */
public final class Suggestion {
    private static final int MOST_MISTAKES = 2;

    /** With a mistake in each letter but one, a short word could be any other. */
    private static final int LETTERS_A_MISTAKE = 2;

    private Suggestion() {}

    /**
     * The end of a sentence that asks for the likeliest word.
     *
     * @param typed what was typed
     * @param words what would have been right
     * @return {@code "; did you mean headPan?"}, or nothing when no word is near
     */
    public static String didYouMean(String typed, Collection<String> words) {
        return nearest(typed, words).map(word -> "; did you mean " + word + "?").orElse("");
    }

    /** Returns the word that was probably meant; empty if none is near. */
    public static Optional<String> nearest(String typed, Collection<String> words) {
        return words.stream()
                .filter(word -> distance(typed, word) <= mostMistakes(typed))
                .min(Comparator.comparingInt(word -> distance(typed, word)));
    }

    private static int mostMistakes(String typed) {
        return Math.min(MOST_MISTAKES, typed.length() / LETTERS_A_MISTAKE);
    }

    /** How many letters have to be added, dropped or changed (Levenshtein), whatever their case. */
    private static int distance(String typed, String word) {
        String from = typed.toLowerCase(Locale.ROOT);
        String to = word.toLowerCase(Locale.ROOT);
        int[] row = new int[to.length() + 1];
        for (int column = 0; column <= to.length(); column++) {
            row[column] = column;
        }
        for (int line = 1; line <= from.length(); line++) {
            int diagonal = row[0];
            row[0] = line;
            for (int column = 1; column <= to.length(); column++) {
                int changed = diagonal + (from.charAt(line - 1) == to.charAt(column - 1) ? 0 : 1);
                diagonal = row[column];
                row[column] = Math.min(changed, 1 + Math.min(row[column], row[column - 1]));
            }
        }
        return row[to.length()];
    }
}
