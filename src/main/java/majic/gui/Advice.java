package majic.gui;

/** Puts what went wrong and what to try into one text. */
final class Advice {
    private Advice() {}

    /** Both as sentences, the advice only once. */
    static String after(String problem, String advice) {
        if (problem.contains(advice)) {
            return problem;
        }
        boolean ended = problem.endsWith(".") || problem.endsWith("?");
        return problem + (ended ? " " : ". ") + advice;
    }
}
