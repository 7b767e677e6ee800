package majic.script.help;

import java.util.List;
import majic.act.ActArgument;
import majic.bot.Parameter;
import majic.script.commands.Help;
import majic.script.run.Questions.Question;

/** How a question is answered: by one of some words, or by a value that is typed. Immutable. */
public record AnswerForm(Question question) {
    /** More words than these are typed. */
    private static final int MOST_WORDS = 5;

    /** Returns the words that answer it, for a button each; none if the answer is typed. */
    public List<String> words() {
        List<String> words = allWords();
        return words.size() > MOST_WORDS ? List.of() : words;
    }

    private List<String> allWords() {
        return switch (question.wanted().kind()) {
            case YES_NO -> List.of("yes", "no");
            case ON_OFF -> List.of("on", "off");
            case CHOICE -> question.wanted().choices();
            case NUMBER, TEXT, LIST -> List.of();
        };
    }

    /** Returns what may be typed, in a few words: a range with its unit, words, or the kind of value. */
    public String range() {
        return Help.values(question.wanted());
    }

    /** Returns the default as it is typed. */
    public String initial() {
        return isText() ? question.otherwise().toString() : ActArgument.typed(question.otherwise());
    }

    /**
     * Returns the line that answers the question.
     *
     * @param typed the answer; a text is without quotes, and a quote in it becomes an apostrophe
     */
    public String line(String typed) {
        return "answer " + (isText() ? '"' + typed.replace('"', '\'') + '"' : typed.strip());
    }

    private boolean isText() {
        return question.wanted().kind() == Parameter.Kind.TEXT;
    }
}
