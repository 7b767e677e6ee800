package majic.figures;

import java.awt.AWTException;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import javax.swing.JFrame;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import majic.gui.kit.ClosesByEsc;

/**
 * How long each action of the command line keeps the event dispatch thread busy: from the key until the window is
 * painted and nothing that follows is left. The processor time of that thread is measured, which other programs do not
 * change.
 */
final class LineTimes {
    private static final int SETTLING_MS = 5000;
    private static final int EARLIER_LINES = 500;
    private static final int ROUNDS = 25;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    /**
     * One action.
     *
     * @param before what is typed first; {@code \t} is Tab, {@code \n} Enter, {@code ^} Up, {@code _} Down, {@code #}
     *     Esc, {@code @} Ctrl R
     * @param key the measured key, of the same kind
     */
    private record Action(String name, String before, char key) {}

    private static final List<Action> ACTIONS = List.of(
            new Action("typing the first letter", "", '1'),
            new Action("typing a command", "1 ", 'm'),
            new Action("typing a parameter", "1 get ", 'd'),
            new Action("typing an act", "1 act ", 'W'),
            new Action("typing a file", "run ", 's'),
            new Action("Tab completes", "1 get distanceFr", '\t'),
            new Action("Tab puts the next one", "1 get d\t", '\t'),
            new Action("Down chooses", "1 get d", '_'),
            new Action("Enter takes the choice", "1 get d_", '\n'),
            new Action("Esc closes the list", "1 get d", '#'),
            new Action("Enter runs a line", "1 get cruise", '\n'),
            new Action("Enter marks a wrong word", "1 mvoe 50", '\n'),
            new Action("a key removes the mark", "1 mvoe 50\n", ' '),
            new Action("Up recalls a line", "", '^'),
            new Action("Down recalls a line", "^^", '_'),
            new Action("Ctrl R searches", "", '@'),
            new Action("typing in the search", "@bo", 't'),
            new Action("Ctrl R goes on", "@bo", '@'),
            new Action("Enter takes the line found", "@bo", '\n'),
            new Action("nothing", "1 ge", ' '));

    private final JTextField line;
    private final Robot robot;
    private final long thread;

    private LineTimes(JTextField line) throws AWTException, InterruptedException, InvocationTargetException {
        this.line = line;
        this.robot = new Robot();
        long[] id = new long[1];
        SwingUtilities.invokeAndWait(() -> id[0] = Thread.currentThread().getId());
        this.thread = id[0];
    }

    /** Measures every action, with {@value #EARLIER_LINES} earlier lines and their answers in the window. */
    static List<String> measure(JFrame frame) throws Exception {
        Thread.sleep(SETTLING_MS);
        LineTimes times = new LineTimes((JTextField) EventDelays.find(frame, "commandLine"));
        times.fillHistory();
        Thread.sleep(SETTLING_MS);
        List<String> lines = new ArrayList<>();
        for (Action action : ACTIONS) {
            lines.add(times.measure(action));
        }
        return lines;
    }

    private void fillHistory() throws InterruptedException, InvocationTargetException {
        for (int number = 0; number < EARLIER_LINES; number++) {
            String text = "bots # " + number;
            SwingUtilities.invokeAndWait(() -> {
                line.setText(text);
                line.postActionEvent();
            });
        }
    }

    private String measure(Action action) throws InterruptedException, InvocationTargetException {
        List<Double> milliseconds = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            prepare(action);
            milliseconds.add(millisecondsOf(action.name().equals("nothing") ? "" : String.valueOf(action.key())));
        }
        double first = milliseconds.get(0);
        Collections.sort(milliseconds);
        return String.format(
                Locale.ROOT,
                "%-27s first %5.1f ms, median %5.1f ms, longest %5.1f ms",
                action.name(),
                first,
                milliseconds.get(ROUNDS / 2),
                milliseconds.get(ROUNDS - 1));
    }

    private void prepare(Action action) throws InterruptedException, InvocationTargetException {
        SwingUtilities.invokeAndWait(() -> {
            line.requestFocusInWindow();
            if (((ClosesByEsc) line).hasToClose()) {
                press(KeyEvent.VK_ESCAPE, 0);
            }
        });
        robot.waitForIdle();
        SwingUtilities.invokeAndWait(() -> line.setText(""));
        robot.waitForIdle();
        for (char key : action.before().toCharArray()) {
            post(key);
            robot.waitForIdle();
        }
        if (!line.isFocusOwner()) {
            throw new IllegalStateException("the command line has lost the focus to another window");
        }
    }

    private double millisecondsOf(String keys) {
        long began = THREADS.getThreadCpuTime(thread);
        keys.chars().forEach(key -> post((char) key));
        robot.waitForIdle();
        return (THREADS.getThreadCpuTime(thread) - began) / 1e6;
    }

    private void post(char key) {
        switch (key) {
            case '\t' -> press(KeyEvent.VK_TAB, 0);
            case '\n' -> press(KeyEvent.VK_ENTER, 0);
            case '^' -> press(KeyEvent.VK_UP, 0);
            case '_' -> press(KeyEvent.VK_DOWN, 0);
            case '#' -> press(KeyEvent.VK_ESCAPE, 0);
            case '@' -> press(KeyEvent.VK_R, KeyEvent.CTRL_DOWN_MASK);
            default -> post(KeyEvent.KEY_TYPED, 0, KeyEvent.VK_UNDEFINED, key);
        }
    }

    private void press(int code, int modifiers) {
        post(KeyEvent.KEY_PRESSED, modifiers, code, KeyEvent.CHAR_UNDEFINED);
        post(KeyEvent.KEY_RELEASED, modifiers, code, KeyEvent.CHAR_UNDEFINED);
    }

    private void post(int event, int modifiers, int code, char typed) {
        Toolkit.getDefaultToolkit()
                .getSystemEventQueue()
                .postEvent(new KeyEvent(line, event, System.currentTimeMillis(), modifiers, code, typed));
    }
}
