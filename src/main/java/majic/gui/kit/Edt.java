package majic.gui.kit;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import majic.bot.BotException;

/** The one way onto the event dispatch thread, and the one way off it. */
public final class Edt {
    private static final Logger LOG = System.getLogger(Edt.class.getName());

    private Edt() {}

    /** Does something to the window soon; callable from any thread, keeps the order of one caller. */
    public static void later(Runnable change) {
        SwingUtilities.invokeLater(change);
    }

    /**
     * Does something that may wait, such as talking to a robot, on a daemon thread of its own.
     *
     * @param name what a thread dump shows
     * @param work handles its own failures
     */
    public static void background(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * As {@link #background(String, Runnable)}, for work that may fail.
     *
     * @param doing what a thread dump and the log show
     * @param work what to do
     * @param failed takes the failure as a sentence, on the event dispatch thread
     */
    public static void background(String doing, Runnable work, Consumer<String> failed) {
        try {
            background(doing, () -> attempt(doing, work, failed));
        } catch (OutOfMemoryError e) {
            failed.accept("The system has no thread left for " + doing + "; end another program and try again.");
        }
    }

    private static void attempt(String doing, Runnable work, Consumer<String> failed) {
        try {
            work.run();
        } catch (BotException | InvalidPathException e) {
            later(() -> failed.accept(String.valueOf(e.getMessage())));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, doing + " failed", e);
            later(() -> failed.accept("An error in MAJIC, see its log."));
        }
    }
}
