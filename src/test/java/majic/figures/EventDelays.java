package majic.figures;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** How long events keep the event dispatch thread busy. */
final class EventTimes extends EventQueue {
    private static final int SETTLING_S = 40;
    private static final int MEASURED_S = 60;
    private static final int DIALOG_S = 3;

    private final List<Long> nanos = Collections.synchronizedList(new ArrayList<>());

    /** Measures while robots report and move, then while dialogs open and the look changes. */
    static List<String> measure(JFrame frame) throws Exception {
        Thread.sleep(SETTLING_S * 1000);
        EventTimes queue = new EventTimes();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
        List<String> lines = new ArrayList<>();
        lines.add(queue.during("20 robots at rest", MEASURED_S, () -> {}));
        lines.add(queue.during("20 robots driving", MEASURED_S, () -> command(frame, "all move 600")));
        for (String dialog : List.of("Add Bot", "Load Act", "Help")) {
            lines.add(queue.during("opening " + dialog, DIALOG_S, () -> press(frame, dialog)));
            SwingUtilities.invokeAndWait(() -> List.of(frame.getOwnedWindows()).forEach(Window::dispose));
        }
        for (String look : List.of("Dark", "Light")) {
            lines.add(queue.during("look " + look, DIALOG_S, () -> choose(frame, look)));
        }
        return lines;
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
        long began = System.nanoTime();
        super.dispatchEvent(event);
        nanos.add(System.nanoTime() - began);
    }

    private String during(String what, int seconds, Runnable action) throws InterruptedException {
        nanos.clear();
        SwingUtilities.invokeLater(action);
        Thread.sleep(seconds * 1000L);
        List<Long> sorted = new ArrayList<>(nanos);
        Collections.sort(sorted);
        double p99 = sorted.get(sorted.size() * 99 / 100) / 1e6;
        double longest = sorted.get(sorted.size() - 1) / 1e6;
        double busy = sorted.stream().mapToLong(Long::longValue).sum() / 1e7 / seconds;
        return String.format(
                Locale.ROOT,
                "%-20s 99 of 100 within %5.1f ms, longest %5.1f ms, busy %4.1f %%",
                what,
                p99,
                longest,
                busy);
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
