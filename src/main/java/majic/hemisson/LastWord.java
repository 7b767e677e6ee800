package majic.hemisson;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;

/**
 * Says farewell when the program ends without having closed the connection, by Ctrl-C or an error: nothing on the robot
 * would ever stop it (Hemisson sheet 5).
 */
final class LastWord {
    private static final Logger LOG = System.getLogger(LastWord.class.getName());

    private final Thread hook;

    private LastWord(Runnable farewell) {
        hook = new Thread(farewell, "hemisson last word");
    }

    /** From now on the end of the program says it first. */
    static LastWord begin(Runnable farewell) {
        LastWord last = new LastWord(farewell);
        try {
            Runtime.getRuntime().addShutdownHook(last.hook);
        } catch (IllegalStateException e) {
            LOG.log(Level.DEBUG, "the program ends already", e);
        }
        return last;
    }

    /** The connection ends in order. */
    void end() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            LOG.log(Level.DEBUG, "the program ends, and says it", e);
        }
    }
}
