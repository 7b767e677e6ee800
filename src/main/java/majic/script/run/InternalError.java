package majic.script.run;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.text.ClassReason;

/** Reports an unexpected error: the log gets its stack trace, the answer a sentence. */
public final class InternalError {
    private static final Logger LOG = System.getLogger(InternalError.class.getName());

    private InternalError() {}

    /** Logs it, and returns the words for the answer. */
    public static String report(String doing, Throwable why) {
        LOG.log(Level.ERROR, doing + " failed", why);
        return ClassReason.ofUnexpected(why);
    }
}
