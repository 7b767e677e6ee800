package majic.gui.kit;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.text.LateLogger;
import majic.text.Texts;

/** Runs tasks on the event dispatch thread, and blocking tasks off it. */
public final class EventThread {
    private static final Logger LOG = LateLogger.of(EventThread.class);
    private static final Texts TEXTS = Texts.of(EventThread.class);

    /** Used on the event dispatch thread only; the first one is running or has its event. */
    private static final Deque<Runnable> PIECES = new ArrayDeque<>();

    private EventThread() {}

    /** Schedules a task on the event dispatch thread; callable from any thread, keeps the order of each caller. */
    public static void later(Runnable change) {
        SwingUtilities.invokeLater(change);
    }

    /**
     * Runs a piece of longer work in an event of its own, after the pieces added before. Events that arrive meanwhile,
     * such as the key of STOP, are handled between two pieces. A piece may add further ones. Must be called on the
     * event dispatch thread.
     */
    public static void piece(Runnable work) {
        PIECES.add(work);
        if (PIECES.size() == 1) {
            later(EventThread::runPiece);
        }
    }

    private static void runPiece() {
        try {
            PIECES.element().run();
        } finally {
            PIECES.remove();
            if (!PIECES.isEmpty()) {
                later(EventThread::runPiece);
            }
        }
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
