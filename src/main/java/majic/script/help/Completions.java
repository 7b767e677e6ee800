package majic.script.help;

import java.util.List;

/**
 * The completions at a place of a line. Immutable.
 *
 * @param start where the begun word starts, 0 to the length of the line; a completion replaces the text from here to the
 *     caret
 * @param entries the words that begin like the begun word, sorted and without repetition; then hints
 */
public record Completions(int start, List<Completion> entries) {
    /** Keeps a copy of the list. */
    public Completions {
        entries = List.copyOf(entries);
    }

    /**
     * Returns the words without hints.
     *
     * @return whole words, sorted
     */
    public List<String> words() {
        return entries.stream()
                .filter(entry -> !entry.isHint())
                .map(Completion::text)
                .toList();
    }
}
