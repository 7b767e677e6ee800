package majic.script.run;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;

/** What nobody has foreseen: the log gets all of it, the person a line. */
public final class InternalError {
    private static final Logger LOG = System.getLogger(InternalError.class.getName());

    private InternalError() {}

    /** Logs it, and tells how to say it. */
    public static String told(String doing, Throwable why) {
        LOG.log(Level.ERROR, doing + " failed", why);
        return "an error in MAJIC, see its log";
    }
}
