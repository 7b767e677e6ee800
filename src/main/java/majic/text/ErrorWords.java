package majic.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Puts the English sentences of drivers and files into the language of the window, by a list of sentences with gaps.
 * What is not in the list stays English, and so do all answers of MAJIC Script. Thread-safe.
 */
public final class ErrorWords {
    /** Where a sentence can end, and another one follows. */
    private static final Pattern JOINT = Pattern.compile("(?<=[.?!]) |; |: |\\. ");

    /** A gap is filled by a part of one sentence, or by nothing. */
    private static final String FILLING = "((?:(?![.?!;] ).)*?)";

    /** A reason in brackets, behind a sentence that is in the language of the window already. */
    private static final Pattern IN_BRACKETS = Pattern.compile("\\(([^()]+)\\)");

    private static final Pattern GAP = Pattern.compile("\\{(\\d)}");

    private ErrorWords() {}

    /**
     * A sentence of the list. Immutable.
     *
     * @param english the sentence, with gaps
     * @param part its longest part without a gap, looked for first since that takes less time
     * @param german the translation, with the numbers of the gaps in braces
     */
    private record Sentence(String english, String part, String german) {
        static Sentence of(String line) {
            String[] both = line.split(" => ", 2);
            String part = GAP.splitAsStream(both[0])
                    .max(Comparator.comparingInt(String::length))
                    .orElseThrow();
            return new Sentence(both[0], part, both[1]);
        }

        /** Returns how many characters of the sentence are in no gap. */
        int letters() {
            return english.length()
                    - "{0}".length()
                            * (int) english.chars().filter(c -> c == '{').count();
        }

        Optional<String> translated(String text) {
            if (!text.contains(part)) {
                return Optional.empty();
            }
            Matcher matcher = pattern().matcher(text);
            return matcher.matches()
                    ? Optional.of(GAP.matcher(german)
                            .replaceAll(gap -> Matcher.quoteReplacement(
                                    ErrorWords.german(matcher.group(1 + Integer.parseInt(gap.group(1)))))))
                    : Optional.empty();
        }

        /** Returns a pattern with a group for each gap. */
        private Pattern pattern() {
            StringBuilder pattern = new StringBuilder();
            Matcher gap = GAP.matcher(english);
            int from = 0;
            while (gap.find()) {
                pattern.append(Pattern.quote(english.substring(from, gap.start())))
                        .append(FILLING);
                from = gap.end();
            }
            return Pattern.compile(pattern + Pattern.quote(english.substring(from)));
        }
    }

    /** The list, longer sentences first, read when the first error is shown. */
    private static final class German {
        static final List<Sentence> SENTENCES = read();

        private static List<Sentence> read() {
            try (InputStream file = Objects.requireNonNull(ErrorWords.class.getResourceAsStream("errors_de.txt"))) {
                return new String(file.readAllBytes(), StandardCharsets.UTF_8)
                        .lines()
                        .filter(line -> line.contains(" => "))
                        .map(Sentence::of)
                        .sorted(Comparator.comparingInt(Sentence::letters).reversed())
                        .toList();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    /** Returns an error in the language of the window, as far as the list has it. */
    public static String of(String english) {
        return Locale.getDefault().getLanguage().equals("de") ? german(english) : english;
    }

    static String german(String english) {
        return sentence(english).orElseGet(() -> joined(english));
    }

    private static Optional<String> sentence(String english) {
        return German.SENTENCES.stream()
                .flatMap(known -> known.translated(english).stream())
                .findFirst();
    }

    /** Translates sentences that stand behind each other, also behind a name that has no translation. */
    private static String joined(String english) {
        List<MatchResult> joints = JOINT.matcher(english).results().toList();
        for (MatchResult joint : joints) {
            Optional<String> first = sentence(english.substring(0, joint.start()));
            if (first.isPresent()) {
                return first.get() + joint.group() + german(english.substring(joint.end()));
            }
        }
        if (!joints.isEmpty()) {
            int behind = joints.get(0).end();
            String rest = english.substring(behind);
            String german = german(rest);
            if (!german.equals(rest)) {
                return english.substring(0, behind) + german;
            }
        }
        return IN_BRACKETS
                .matcher(english)
                .replaceAll(found ->
                        Matcher.quoteReplacement("(" + sentence(found.group(1)).orElse(found.group(1)) + ")"));
    }
}
