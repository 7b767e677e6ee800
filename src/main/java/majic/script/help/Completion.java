package majic.script.help;

/**
 * What could stand at a place of a line, or what is expected there. Immutable.
 *
 * @param text the whole word; empty for a hint, which states what is expected but completes nothing
 * @param values what it takes, in a few words: a range with its unit, the words to choose from, the arguments of a
 *     command; may be empty
 * @param explanation a phrase without full stop; may be empty
 */
public record Completion(String text, String values, String explanation) {

    /** Creates a word that takes no values. */
    static Completion word(String text, String explanation) {
        return new Completion(text, "", explanation);
    }

    /**
     * Returns whether more follows a word without a blank: an address behind its colon, a file behind its folder, a
     * value behind its equals sign.
     */
    public static boolean goesOn(String word) {
        return word.endsWith(":") || word.endsWith("/") || word.endsWith("=");
    }

    /** Returns whether it only states what is expected. */
    public boolean isHint() {
        return text.isEmpty();
    }

    /**
     * Returns all that is known in one line, such as {@code headPan deg: turns the head} or {@code a distance (mm,
     * cm)}.
     *
     * @return one line, without full stop
     */
    public String inWords() {
        if (isHint()) {
            return values.isEmpty() ? explanation : explanation + " (" + values + ")";
        }
        String word = values.isEmpty() ? text : text + " " + values;
        return explanation.isEmpty() ? word : word + ": " + explanation;
    }
}
