package majic.text;

/** Puts what went wrong and what to try into one text. */
public final class Advice {
    private Advice() {}

    /**
     * Both as sentences. A problem that ends with a question asks what to look at already, and stays alone; general
     * advice behind it would only hide that.
     *
     * @param problem what went wrong, with or without a full stop
     * @param advice one or two whole sentences
     * @return both in one line, the advice at most once
     */
    public static String after(String problem, String advice) {
        if (problem.endsWith("?") || problem.contains(advice)) {
            return problem;
        }
        return problem + (problem.endsWith(".") ? " " : ". ") + advice;
    }

    /**
     * Both as one sentence, with a semicolon between them. Behind a question, which asks what to look at already, a
     * second question is left out, and other advice is a sentence of its own.
     *
     * @param problem what went wrong, without a full stop
     * @param advice begins in lower case or with a quotation mark
     * @return both in one line
     */
    public static String joined(String problem, String advice) {
        if (!problem.endsWith("?")) {
            return problem + "; " + advice;
        }
        return advice.endsWith("?") ? problem : problem + " " + advice;
    }
}
