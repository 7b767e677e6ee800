package majic.gui.kit;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.text.LateLogger;
import majic.text.Texts;

/** Runs tasks on the event dispatch thread, and blocking tasks off it. */
public final class EventThread {
    private static final Logger LOG = LateLogger.of(EventThread.class);
    private static final Texts TEXTS = Texts.of(EventThread.class);

    private EventThread() {}

    /** Schedules a task on the event dispatch thread; callable from any thread, keeps the order of each caller. */
    public static void later(Runnable change) {
        SwingUtilities.invokeLater(change);
    }

    /**
     * Runs work that may block, such as communication with a robot, on a new daemon thread.
     *
     * @param name name of the thread
     * @param work handles its own failures
     */
    public static void background(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Runs work that may block and fail, as {@link #background(String, Runnable)} does.
     *
     * @param doing name of the thread, also used in the log
     * @param work the work
     * @param failed receives the failure as a sentence, on the event dispatch thread
     */
    public static void background(String doing, Runnable work, Consumer<String> failed) {
        try {
            background(doing, () -> attempt(doing, work, failed));
        } catch (OutOfMemoryError e) {
            failed.accept(TEXTS.get("noThread"));
        }
    }

    private static void attempt(String doing, Runnable work, Consumer<String> failed) {
        try {
            work.run();
        } catch (BotException | InvalidPathException e) {
            later(() -> failed.accept(String.valueOf(e.getMessage())));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, doing + " failed", e);
            later(() -> failed.accept(TEXTS.get("error")));
        }
    }
}
