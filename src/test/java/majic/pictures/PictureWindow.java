package majic.pictures;

import java.awt.Component;
import java.awt.Container;
import java.awt.Frame;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.environment.Settings;
import majic.gui.MajicFrame;
import majic.gui.WindowWait;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.ProgramServices.SerialPortChoice;
import majic.gui.replay.ReplayWindow;
import majic.program.Program;
import majic.recorder.RecordingFolder;
import majic.script.MajicParser;
import org.jspecify.annotations.Nullable;

/** Controls the window of which pictures are taken. Used outside the event thread. */
public final class PictureWindow {

    private PictureWindow() {}

    /**
     * Gives the windows that are opened from now on the title bar of the look, so that pictures have it on any system.
     */
    public static void decorate() {
        JFrame.setDefaultLookAndFeelDecorated(true);
        JDialog.setDefaultLookAndFeelDecorated(true);
    }

    public static MajicFrame open(Program program, MajicParser parser) throws Exception {
        return open(program, parser, program.settings());
    }

    /** Opens a window with settings of its own; those of the program may still be written when it has been closed. */
    public static MajicFrame open(Program program, MajicParser parser, Settings settings) throws Exception {
        MajicFrame[] frame = new MajicFrame[1];
        SwingUtilities.invokeAndWait(() -> {
            MajicFrame.installLook(settings);
            ProgramServices services = new ProgramServices(
                    () -> List.of(
                            new SerialPortChoice(
                                    "/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_A50285BI-if00-port0",
                                    "/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_A50285BI-if00-port0 – FT232R USB UART, now /dev/ttyUSB0")),
                    () -> {},
                    program::quit,
                    settings,
                    new RecordingFolder(Path.of("no recordings")),
                    null,
                    null,
                    null);
            frame[0] = new MajicFrame(program.session(), parser, services);
            frame[0].setVisible(true);
        });
        return frame[0];
    }

    public static void add(Program program, MajicParser parser, List<String> types) {
        for (String type : types) {
            int wanted = program.team().members().size() + 1;
            parser.parseText("add sim:" + type);
            WindowWait.await(
                    "the simulated " + type + " to join",
                    () -> program.team().members().size() == wanted);
        }
    }

    /** Becomes true when the messages have had time to be shown. */
    public static final class Settled implements BooleanSupplier {
        private final long startNanos = System.nanoTime();

        @Override
        public boolean getAsBoolean() {
            return System.nanoTime() - startNanos > 1_500_000_000L;
        }
    }

    public static void awaitWindow(BooleanSupplier condition) {
        WindowWait.await("the next picture", condition);
    }

    public static void click(Container parent, String button) throws Exception {
        SwingUtilities.invokeAndWait(() -> ((AbstractButton) find(parent, button)).doClick());
    }

    /** Selects a robot by a click on its tab. */
    public static void select(Container frame, int robot) throws Exception {
        click(find(frame, "tab" + robot), 0);
    }

    /** Adds a robot to the selection by a click with Ctrl. */
    public static void addToSelection(Container frame, int robot) throws Exception {
        click(find(frame, "tab" + robot), InputEvent.CTRL_DOWN_MASK);
    }

    private static void click(Component tab, int modifiers) throws Exception {
        int mask = InputEvent.BUTTON1_DOWN_MASK | modifiers;
        SwingUtilities.invokeAndWait(() -> tab.dispatchEvent(new MouseEvent(
                tab, MouseEvent.MOUSE_PRESSED, System.currentTimeMillis(), mask, 5, 5, 1, false, MouseEvent.BUTTON1)));
    }

    /** Waits for a dialog of the window. */
    public static Container awaitDialog(MajicFrame frame, String title) {
        awaitWindow(() -> dialog(frame, title) != null);
        return Objects.requireNonNull((Container) dialog(frame, title));
    }

    public static @Nullable Window dialog(MajicFrame frame, String title) {
        for (Window window : frame.getOwnedWindows()) {
            if (window instanceof JDialog dialog
                    && dialog.isShowing()
                    && dialog.getTitle().equals(title)) {
                return window;
            }
        }
        return null;
    }

    /** Returns the window that replays a recording; null if none is shown. */
    public static @Nullable JFrame replay() {
        return Stream.of(Frame.getFrames())
                .filter(window -> window instanceof ReplayWindow && window.isShowing())
                .map(JFrame.class::cast)
                .findFirst()
                .orElse(null);
    }

    public static boolean isShowing(Container parent, String name) {
        Component found = search(parent, name);
        return found != null && found.isShowing();
    }

    public static Component find(Container parent, String name) {
        Component found = search(parent, name);
        return Objects.requireNonNull(found, name);
    }

    private static @Nullable Component search(Container parent, String name) {
        for (Component child : parent.getComponents()) {
            Component found = name.equals(child.getName())
                    ? child
                    : child instanceof Container inner ? search(inner, name) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }
}
