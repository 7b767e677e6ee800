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
}
