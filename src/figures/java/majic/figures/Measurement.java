package majic.figures;

import java.util.List;
import java.util.concurrent.Callable;

/** The work of a program that measures. */
public final class Measurement {
    private Measurement() {}

    /**
     * Prints what the work returns and ends the program, whatever threads are left: with exit code 0, or with 1 and the
     * stack in the error output if the work throws.
     *
     * @param work returns lines of figures
     */
    public static void run(Callable<List<String>> work) {
        int code = 1;
        try {
            work.call().forEach(System.out::println);
            code = 0;
        } catch (Throwable e) {
            e.printStackTrace();
        }
        System.out.flush();
        Runtime.getRuntime().halt(code);
    }
}
