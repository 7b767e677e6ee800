package majic.script.help;

import java.util.List;
import java.util.Optional;

/**
 * The completions at a place of a line. Immutable.
 *
 * @param start where the begun word starts, 0 to the length of the line; a completion replaces the text from here to
 *     the caret
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

    /**
     * Finds what a word means that stands at the place.
     *
     * @param word from the start to the caret; may be empty
     * @return the entry that is this word, in any case of its letters; else what is expected at the place; empty if
     *     neither is known
     */
    public Optional<Completion> meaning(String word) {
        return entries.stream()
                .filter(entry -> !entry.isHint() && entry.text().equalsIgnoreCase(word))
                .findFirst()
                .or(() -> entries.stream().filter(Completion::isHint).findFirst());
    }
}
