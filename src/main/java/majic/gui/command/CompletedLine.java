package majic.gui.command;

import java.util.List;
import java.util.Locale;

/**
 * The result of completing a line with the Tab key. Immutable.
 *
 * @param text the line afterwards
 * @param caret position of the caret afterwards
 * @param choices the words to choose from; empty when there was one or none
 */
record CompletedLine(String text, int caret, List<String> choices) {

    /** Completes the word before the caret with the longest common prefix of all candidates. */
    static CompletedLine complete(String text, int caret, List<String> candidates) {
        if (candidates.isEmpty()) {
            return new CompletedLine(text, caret, List.of());
        }
        int start = wordStart(text, caret);
        String typed = text.substring(start, caret);
        boolean one = candidates.size() == 1;
        String word = one ? candidates.get(0) : commonStart(candidates);
        if (word.length() < typed.length()) {
            word = typed;
        }
        String tail = text.substring(caret);
        String gap = one && !tail.startsWith(" ") ? " " : "";
        String line = text.substring(0, start) + word + gap + tail;
        return new CompletedLine(line, start + word.length() + gap.length(), one ? List.of() : List.copyOf(candidates));
    }

    private static int wordStart(String text, int caret) {
        int start = caret;
        while (start > 0 && " \t,(.".indexOf(text.charAt(start - 1)) < 0) {
            start--;
        }
        return start;
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
