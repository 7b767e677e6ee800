package majic.script;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;

/** What nobody has foreseen: the log gets all of it, the person a line. */
final class InternalError {
    private static final Logger LOG = System.getLogger(InternalError.class.getName());

    private InternalError() {}

    /** Logs it, and tells how to say it. */
    static String told(String doing, Throwable why) {
        LOG.log(Level.ERROR, doing + " failed", why);
        return "an error in MAJIC, see its log";
    }
}
