package majic.figures;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.Window;
import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.Majic;

/** A measured program: waits for its window, measures it in its own process, prints the result and ends. */
final class MeasuredWindow {
    /** The line that a program prints when its window is visible. */
    static final String SHOWN = "shown";

    private static final int LOOK_MS = 1;
    private static final int LONGEST_START_S = 60;

    /** Tasks that start what they need themselves. */
    private static final Set<String> WITHOUT_WINDOW = Set.of("flood", "stop");

    private MeasuredWindow() {}

    /** Runs the task of the first argument; the others are MAJIC's. */
    public static void main(String[] arguments) {
        Thread measuring = new Thread(() -> Measurement.run(() -> measure(List.of(arguments))), "figures");
        measuring.start();
        if (arguments[0].equals("bare")) {
            SwingUtilities.invokeLater(MeasuredWindow::showBareFrame);
        } else if (!WITHOUT_WINDOW.contains(arguments[0])) {
            Majic.main(Arrays.copyOfRange(arguments, 1, arguments.length));
        }
    }

    /**
     * Waits for a window without loading the toolkit, then until the display has asked for its painting, which it does
     * once the window is visible, and that is done.
     */
    static void awaitWindow() throws InterruptedException, InvocationTargetException {
        while (Window.getWindows().length == 0) {
            Thread.sleep(LOOK_MS);
        }
        CountDownLatch asked = new CountDownLatch(1);
        Toolkit.getDefaultToolkit().addAWTEventListener(event -> asked.countDown(), AWTEvent.PAINT_EVENT_MASK);
        if (!asked.await(LONGEST_START_S, TimeUnit.SECONDS)) {
            throw new IllegalStateException("the display has not asked for the painting of the window");
        }
        SwingUtilities.invokeAndWait(() -> {});
    }

    private static void showBareFrame() {
        FlatLightLaf.setup();
        JFrame frame = new JFrame("bare");
        frame.add(new JLabel("a bare frame"));
        frame.setSize(1280, 800);
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
    }

    private static List<String> measure(List<String> arguments) throws Exception {
        String task = arguments.get(0);
        List<String> rest = arguments.subList(1, arguments.size());
        if (!WITHOUT_WINDOW.contains(task)) {
            awaitWindow();
        }
        return switch (task) {
            case "bare", "majic" -> List.of(SHOWN);
            case "idle" -> ThreadLoads.idle();
            case "events" -> EventDelays.measure(frame());
            case "large" -> EventDelays.measureLarge(frame(), Figures.LARGE_TEAM);
            case "line" -> LineTimes.measure(frame());
            case "flood" -> ClientFlood.measure();
            case "stop" -> StopTimes.measure(rest);
            case "memory" -> MemoryInUse.overAnHour(frame());
            default -> throw new IllegalArgumentException("no task " + task);
        };
    }

    private static JFrame frame() {
        return Arrays.stream(Window.getWindows())
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst()
                .orElseThrow();
    }
}
