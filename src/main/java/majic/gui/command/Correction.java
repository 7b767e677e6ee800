package majic.gui.command;

import java.util.Optional;
import java.util.regex.Pattern;
import majic.script.MajicParser;
import majic.script.Refusal;

/**
 * Distinguishes what is typed over the wrong word of a refused line: a correction of the word, or a new line. It is a
 * new line as soon as it fits at the beginning of a line, but not in place of the word. Immutable.
 *
 * @param before the line up to the word
 * @param after the line behind it
 */
record Correction(String before, String after) {
    private static final Pattern ROBOTS = Pattern.compile("\\d[\\d,-]*\\s+\\S.*");
    private static final Pattern SECOND_WORD = Pattern.compile("\\s*\\S+\\s+\\S.*");

    static Correction of(String line, Refusal why) {
        return new Correction(line.substring(0, why.from()), line.substring(why.to()));
    }

    /**
     * Returns what was typed over the word, if it is a new line.
     *
     * @param line the whole line with it
     * @param caret the place of the caret in the line
     */
    Optional<String> newLine(MajicParser parser, String line, int caret) {
        boolean inPlace = caret > before.length()
                && caret == line.length() - after.length()
                && line.startsWith(before)
                && line.endsWith(after);
        return Optional.of(line)
                .filter(present -> inPlace)
                .map(present -> present.substring(before.length(), caret))
                .filter(typed -> isNewLine(parser, typed));
    }

    private boolean isNewLine(MajicParser parser, String typed) {
        if (before.isBlank()) {
            return !after.isBlank() && SECOND_WORD.matcher(typed).matches();
        }
        return !fits(parser, before + typed) && (ROBOTS.matcher(typed).matches() || fits(parser, typed));
    }

    /** Returns whether the last word of a line can stand there; assumed where files would have to be read. */
    private static boolean fits(MajicParser parser, String line) {
        return MajicParser.readsFiles(line)
                || !parser.complete(line, line.length()).entries().isEmpty();
    }
}
