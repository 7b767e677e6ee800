package majic.program;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
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
     * Returns why no window can be opened here, as the first half of a sentence; may block while the display is being
     * connected.
     *
     * @return empty if there is a display that can be used
     */
    public static Optional<String> displayProblem() {
        if (GraphicsEnvironment.isHeadless()) {
            return Optional.of("there is no display here");
        }
        try {
            Toolkit.getDefaultToolkit();
            return Optional.empty();
        } catch (AWTError | LinkageError e) {
            // The second and later attempts fail with the error of a class that could not be initialised.
            return Optional.of("the display " + System.getenv("DISPLAY") + ", which DISPLAY names, cannot be used");
        }
    }

    /**
     * Shows the window and blocks until the end of the program.
     *
     * @param firstRobots asked for the robots to add once the window is painted; may block then
     * @return the exit status
     */
    public int run(FirstRobots.Source firstRobots) {
        MajicFrame frame = open(true);
        begin(firstRobots);
        try {
            program.awaitQuit();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        program.close();
        SwingUtilities.invokeLater(frame::dispose);
        return 0;
    }

    /** Begins the session, and adds its first robots in the background. */
    private void begin(FirstRobots.Source firstRobots) {
        program.announce();
        Thread adding = new Thread(() -> add(firstRobots), "adding robots");
        adding.setDaemon(true);
        adding.start();
    }

    private void add(FirstRobots.Source firstRobots) {
        try {
            program.addFirst(robotsOrNone(firstRobots));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private FirstRobots robotsOrNone(FirstRobots.Source firstRobots) {
        try {
            return firstRobots.firstRobots(program);
        } catch (BotException e) {
            program.session().alarm(String.valueOf(e.getMessage()));
            return FirstRobots.NONE;
        }
    }

    /**
     * Builds and paints the window and its dialogs without showing them, and waits a little for what the window does in
     * the background once it is open. Takes the same steps as {@link #run}, since what is not rehearsed delays each
     * start.
     */
    public void rehearse() throws InterruptedException {
        MajicFrame frame = open(false);
        begin(rehearsed -> FirstRobots.NONE);
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

    /**
     * Builds the window and waits for the events of its opening, the first painting among them: what begins afterwards
     * does not delay it.
     */
    private MajicFrame open(boolean visible) {
        WindowPreloader.prepareWindow();
        AtomicReference<MajicFrame> frame = new AtomicReference<>();
        onEventThread(() -> {
            MajicFrame built = build();
            built.setVisible(visible);
            frame.set(built);
        });
        onEventThread(() -> {});
        return frame.get();
    }

    private static void onEventThread(Runnable work) {
        try {
            SwingUtilities.invokeAndWait(work);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new WindowFailed(e);
        }
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
        try {
            return SerialPorts.system().list().stream()
                    .map(port -> new SerialPortChoice(port.name(), port.toString()))
                    .toList();
        } catch (IOException e) {
            throw new BotException(String.valueOf(e.getMessage()), e);
        }
    }

    /** Reports that the window could not be opened. */
    static final class WindowFailed extends RuntimeException {
        private static final long serialVersionUID = 1;

        WindowFailed(Throwable cause) {
            super("the window cannot be opened (" + reason(cause) + "); try --console", cause);
        }

        private static String reason(Throwable cause) {
            Throwable root = cause.getCause() == null ? cause : cause.getCause();
            return root.getMessage() == null
                    ? root.getClass().getSimpleName()
                    : root.getMessage().strip().lines().findFirst().orElse("");
        }
    }
}
