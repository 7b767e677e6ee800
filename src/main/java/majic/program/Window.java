package majic.program;

import java.awt.AWTError;
import java.awt.HeadlessException;
import java.awt.event.WindowEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.gui.MajicFrame;
import majic.gui.WindowPreloader;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import majic.link.SerialPorts;
import majic.script.MajicParser;

/** Opens the window and blocks until the program is asked to end. */
public final class Window {
    private static final int REHEARSED_MS = 2000;

    private final Program program;
    private final MajicParser parser;

    public Window(Program program) {
        this.program = program;
        this.parser = MajicParser.prompt(program.session());
    }

    /**
     * Begins to load in the background what every window needs; to be called before the program is built. Has no effect
     * without a display, and when called again.
     */
    public static void preload() {
        WindowPreloader.start();
    }

    /**
     * Shows the window and blocks until the end of the program.
     *
     * @param firstRobots returns the robots to add; called once the window is painted, and may block then
     * @return the exit status
     * @throws UsageException if the display cannot be used
     */
    public int run(Supplier<FirstRobots> firstRobots) {
        WindowPreloader.prepareWindow();
        MajicFrame frame = open(this::show);
        awaitPainted();
        program.announce();
        Thread adding = new Thread(() -> add(firstRobots), "adding robots");
        adding.setDaemon(true);
        adding.start();
        try {
            program.awaitQuit();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        program.close();
        SwingUtilities.invokeLater(frame::dispose);
        return 0;
    }

    /** Waits for the events of the opening, the first painting among them: what begins now does not delay it. */
    private static void awaitPainted() {
        onEventThread(() -> {});
    }

    private void add(Supplier<FirstRobots> firstRobots) {
        try {
            program.addFirst(robotsOrNone(firstRobots));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private FirstRobots robotsOrNone(Supplier<FirstRobots> firstRobots) {
        try {
            return firstRobots.get();
        } catch (BotException e) {
            program.session().alarm(String.valueOf(e.getMessage()));
            return FirstRobots.NONE;
        }
    }

    /**
     * Builds and paints the window and its dialogs without showing them, and waits a little for what the window does in
     * the background once it is open.
     */
    public void rehearse() throws InterruptedException {
        MajicFrame frame = open(this::build);
        program.announce();
        onEventThread(() -> {
            frame.addNotify();
            frame.validate();
            frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_OPENED));
        });
        Thread.sleep(REHEARSED_MS);
        onEventThread(() -> {
            frame.rehearse();
            frame.dispose();
        });
    }

    private MajicFrame open(Supplier<MajicFrame> making) {
        AtomicReference<MajicFrame> frame = new AtomicReference<>();
        onEventThread(() -> frame.set(making.get()));
        return frame.get();
    }

    private static void onEventThread(Runnable work) {
        try {
            SwingUtilities.invokeAndWait(work);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException | AWTError e) {
            throw new WindowFailed(e);
        }
    }

    private MajicFrame show() {
        MajicFrame frame = build();
        frame.setVisible(true);
        return frame;
    }

    private MajicFrame build() {
        MajicFrame.installLook(program.settings());
        ProgramServices services = new ProgramServices(
                Window::serialPorts,
                program::startLab,
                program::quit,
                program.settings(),
                program.recordings(),
                program.recorder().orElse(null),
                program.folder().file("command-history"),
                program.sharing());
        return new MajicFrame(program.session(), parser, services);
    }

    private static List<SerialPortChoice> serialPorts() {
        return SerialPorts.list().stream()
                .map(port -> new SerialPortChoice(port.name(), port.description()))
                .toList();
    }

    /** Reports that the window could not be opened. */
    static final class WindowFailed extends RuntimeException {
        private static final long serialVersionUID = 1;

        WindowFailed(Throwable cause) {
            super("the window cannot be opened (" + reason(cause) + "); try --console", cause);
        }

        private static String reason(Throwable cause) {
            Throwable root = cause.getCause() == null ? cause : cause.getCause();
            return root instanceof HeadlessException || root.getMessage() == null
                    ? "the display cannot be used"
                    : root.getMessage().strip().lines().findFirst().orElse("the display cannot be used");
        }
    }
}
