package majic.panel;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import majic.text.Texts;

/**
 * Makes the values of a panel that can be plotted usable by keyboard: together they are one stop of the Tab key, Up and
 * Down move among them. Must be used on the event dispatch thread.
 */
final class ReadingKeys {
    private static final Texts TEXTS = Texts.of(ReadingKeys.class);

    private final List<JLabel> values = new ArrayList<>();
    private final List<List<String>> parameters = new ArrayList<>();

    /** Adds a value, below the others. */
    void add(JLabel value, List<String> plotted) {
        values.add(value);
        parameters.add(plotted);
        bind(value, KeyEvent.VK_UP, -1);
        bind(value, KeyEvent.VK_DOWN, 1);
    }

    private void bind(JLabel value, int key, int step) {
        KeyAction.bind(value, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0), event -> move(value, step));
    }

    private void move(JLabel from, int step) {
        int count = values.size();
        int start = values.indexOf(from);
        for (int distance = 1; distance < count; distance++) {
            int index = Math.floorMod(start + step * distance, count);
            JLabel next = values.get(index);
            if (next.isVisible() && isPlottable(index)) {
                next.setFocusable(true);
                next.requestFocusInWindow();
                from.setFocusable(false);
                return;
            }
        }
    }

    private boolean isPlottable(int index) {
        return parameters.get(index).stream().anyMatch(parameter -> PlotLink.isPlottable(values.get(index), parameter));
    }

    /** Makes the first value that can be plotted the one that Tab reaches. */
    void update() {
        boolean found = false;
        for (int index = 0; index < values.size(); index++) {
            boolean first = !found && isPlottable(index);
            values.get(index).setFocusable(first);
            values.get(index)
                    .getAccessibleContext()
                    .setAccessibleDescription(
                            isPlottable(index)
                                    ? TEXTS.get("enterPlots", String.join(", ", parameters.get(index)))
                                    : null);
            found |= first;
        }
    }
}
