package majic.figures;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import majic.panel.PlotHost;

/**
 * How long the event dispatch thread lets tasks wait, and how much processor time it and its longest event use. On a
 * busy computer, the processor times still count; the delays do not.
 */
final class EventDelays extends EventQueue {
    private static final int SETTLING_S = 40;
    private static final int MEASURED_S = 30;
    private static final int DIALOG_S = 3;
    private static final int PROBE_MS = 10;
    private static final int PLOTS = 4;
    private static final List<String> CURVES = List.of("x", "y", "heading", "speed", "distanceLeft");

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private long longestNanos;
    private long busyNanos;

    /** Measures while robots report and move, then with plots, then while dialogs open and the look changes. */
    static List<String> measure(JFrame frame) throws Exception {
        Thread.sleep(SETTLING_S * 1000);
        EventDelays queue = installed();
        List<String> lines = new ArrayList<>(queue.reports(frame, 20));
        lines.addAll(queue.plots(frame));
        for (String dialog : List.of("Add Bot", "Load Act", "Help")) {
            for (String time : List.of("first", "second")) {
                lines.add(queue.during(dialog + ", " + time + " time", DIALOG_S, () -> press(frame, dialog)));
                SwingUtilities.invokeAndWait(() -> closeWindows(frame));
            }
        }
        for (String look : List.of("Dark", "Light")) {
            lines.add(queue.during("look " + look, DIALOG_S, () -> choose(frame, look)));
        }
        return lines;
    }

    /** Waits for the tabs of a large team, then measures while its robots report and move. */
    static List<String> measureLarge(JFrame frame, int robots) throws Exception {
        long began = System.nanoTime();
        while (((JTabbedPane) find(frame, "mainPane")).getTabCount() < robots) {
            Thread.sleep(PROBE_MS);
        }
        double seconds = (System.nanoTime() - began) / 1e9;
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "%d tabs %.1f s after the window", robots, seconds));
        Thread.sleep(SETTLING_S * 1000);
        lines.addAll(installed().reports(frame, robots));
        return lines;
    }

    private static EventDelays installed() {
        EventDelays queue = new EventDelays();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
        return queue;
    }

    private List<String> reports(JFrame frame, int robots) throws Exception {
        return List.of(
                during(robots + " robots at rest", MEASURED_S, () -> {}),
                during(robots + " robots driving", MEASURED_S, () -> command(frame, "all move 600")));
    }

    /** Measures while plots show moving robots, then while a dialog adds curves to one of them. */
    private List<String> plots(JFrame frame) throws Exception {
        List<String> lines = List.of(
                during("4 plots begin", DIALOG_S, () -> openPlots(frame)),
                during("20 robots, 4 plots", MEASURED_S, () -> command(frame, "all move -600")),
                during("Add Curves", DIALOG_S, () -> ((AbstractButton) shown("addCurves")).doClick(0)),
                during("finding curves", DIALOG_S, () -> ((JTextField) shown("curveFilter")).setText("sonar")),
                during("adding curves", DIALOG_S, EventDelays::addCurves));
        SwingUtilities.invokeAndWait(() -> closeWindows(frame));
        return lines;
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
        long began = THREADS.getCurrentThreadCpuTime();
        super.dispatchEvent(event);
        long nanos = THREADS.getCurrentThreadCpuTime() - began;
        busyNanos += nanos;
        longestNanos = Math.max(longestNanos, nanos);
    }

    /** Begins an action, and gives the event dispatch thread a task every ten milliseconds. */
    private String during(String what, int seconds, Runnable action) throws Exception {
        List<Double> delays = Collections.synchronizedList(new ArrayList<>());
        SwingUtilities.invokeAndWait(() -> {
            busyNanos = 0;
            longestNanos = 0;
        });
        SwingUtilities.invokeLater(action);
        for (int probe = 0; probe < seconds * 1000 / PROBE_MS; probe++) {
            long givenNanos = System.nanoTime();
            SwingUtilities.invokeLater(() -> delays.add((System.nanoTime() - givenNanos) / 1e6));
            Thread.sleep(PROBE_MS);
        }
        String[] line = new String[1];
        SwingUtilities.invokeAndWait(() -> line[0] = line(what, seconds, delays));
        return line[0];
    }

    private String line(String what, int seconds, List<Double> delays) {
        Collections.sort(delays);
        return String.format(
                Locale.ROOT,
                "%-22s delays: 99 of 100 within %5.1f ms, longest %5.1f ms; processor: longest event %5.1f ms, busy %4.1f %%",
                what,
                delays.get(delays.size() * 99 / 100),
                delays.get(delays.size() - 1),
                longestNanos / 1e6,
                busyNanos / 1e7 / seconds);
    }

    private static void openPlots(JFrame frame) {
        for (int robot = 1; robot <= PLOTS; robot++) {
            ((PlotHost) find(frame, "tab" + (robot + 1))).plot(CURVES, false);
        }
    }

    /** Adds the first curves of those that the dialog has found. */
    private static void addCurves() {
        ((JList<?>) shown("parameters")).setSelectionInterval(0, CURVES.size() - 1);
        ((AbstractButton) shown("Add")).doClick(0);
    }

    private static Component shown(String name) {
        return Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .flatMap(window -> search(window, name))
                .findFirst()
                .orElseThrow();
    }

    private static void closeWindows(JFrame frame) {
        Stream.of(Window.getWindows()).filter(window -> window != frame).forEach(Window::dispose);
    }

    private static void command(JFrame frame, String line) {
        JTextField field = (JTextField) find(frame, "commandLine");
        field.setText(line);
        field.postActionEvent();
    }

    private static void press(JFrame frame, String name) {
        ((AbstractButton) find(frame, name)).doClick(0);
    }

    private static void choose(JFrame frame, String entry) {
        for (int menu = 0; menu < frame.getJMenuBar().getMenuCount(); menu++) {
            choose(frame.getJMenuBar().getMenu(menu), entry);
        }
    }

    private static void choose(JMenu menu, String entry) {
        for (int index = 0; index < menu.getItemCount(); index++) {
            JMenuItem item = menu.getItem(index);
            if (item != null && item.getText().startsWith(entry)) {
                item.doClick(0);
            }
        }
    }

    static Component find(Container parent, String name) {
        return search(parent, name).findFirst().orElseThrow();
    }

    private static Stream<Component> search(Container parent, String name) {
        return Stream.of(parent.getComponents()).flatMap(child -> {
            Stream<Component> inside = child instanceof Container inner ? search(inner, name) : Stream.empty();
            return name.equals(child.getName()) ? Stream.of(child) : inside;
        });
    }
}
