package majic.gui.command;

import java.util.List;
import java.util.Locale;
import majic.script.help.Completion;

/**
 * A line after a word of it was completed. Immutable.
 *
 * @param text the line
 * @param caret position of the caret
 */
record CompletedLine(String text, int caret) {

    /**
     * Completes a begun word with the longest common beginning of all candidates; with a single one, with that.
     *
     * @param start where the begun word starts
     * @param caret where it ends
     */
    static CompletedLine complete(String text, int start, int caret, List<String> candidates) {
        if (candidates.isEmpty()) {
            return new CompletedLine(text, caret);
        }
        if (candidates.size() == 1) {
            return with(text, start, caret, candidates.get(0));
        }
        String common = commonStart(candidates);
        return common.length() < caret - start ? new CompletedLine(text, caret) : put(text, start, caret, common);
    }

    /** Puts a whole word in place of a begun one, and a blank behind it unless the word or the line goes on. */
    static CompletedLine with(String text, int start, int caret, String word) {
        boolean ended = Completion.goesOn(word) || text.startsWith(" ", caret);
        return put(text, start, caret, ended ? word : word + " ");
    }

    /** Puts a text in place of a begun word. */
    static CompletedLine put(String text, int start, int caret, String word) {
        return new CompletedLine(text.substring(0, start) + word + text.substring(caret), start + word.length());
    }

    private static String commonStart(List<String> words) {
        String common = words.get(0);
        for (String word : words) {
            int length = 0;
            while (length < Math.min(common.length(), word.length()) && same(common, word, length)) {
                length++;
            }
            common = common.substring(0, length);
        }
        return common;
    }

    private static boolean same(String a, String b, int index) {
        String first = a.substring(index, index + 1).toLowerCase(Locale.ROOT);
        return first.equals(b.substring(index, index + 1).toLowerCase(Locale.ROOT));
    }
}
