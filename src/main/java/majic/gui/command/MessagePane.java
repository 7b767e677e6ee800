package majic.gui.command;

import com.formdev.flatlaf.util.SystemInfo;
import java.awt.BorderLayout;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import majic.environment.Settings;
import majic.gui.kit.EventThread;
import majic.panel.KeyAction;

/** The messages with their controls and keys. The size of the text and the times of day are kept in the settings. */
final class MessagePane extends JPanel {
    private static final long serialVersionUID = 1L;

    /** The start of the keys that menus show, as {@code KeyStroke} reads it. */
    static final String MENU_KEY = SystemInfo.isMacOS ? "meta " : "ctrl ";

    private static final String SIZE = "window.messages.larger";
    private static final String TIMES = "window.messages.times";

    private final transient Settings settings;
    private final MessageArea area = new MessageArea(this::newText);
    private final MessageBar bar;

    /**
     * Creates an empty pane.
     *
     * @param toCommandLine gives the focus to the command line
     */
    MessagePane(Settings settings, Runnable toCommandLine) {
        super(new BorderLayout(0, 2));
        this.settings = settings;
        bar = new MessageBar(area, toCommandLine);
        area.onChange(bar::update);
        add(bar, BorderLayout.NORTH);
        add(area, BorderLayout.CENTER);
    }

    private MessageText newText() {
        MessageText text = new MessageText(() -> new MessageMenu(area, bar::startFind, this::resize, this::keepTimes));
        settings.get(SIZE).ifPresent(points -> text.setLarger(number(points)));
        return text;
    }

    /** Adds what would have delayed the window: the text of the messages and the keys. */
    void complete() {
        area.showTimes(settings.get(TIMES).filter("yes"::equals).isPresent());
        area.text();
        bar.complete();
        bind(MENU_KEY + "F", bar::startFind);
        bind("F3", () -> bar.move(-1));
        bind("shift F3", () -> bar.move(1));
        for (String key : List.of("PLUS", "EQUALS", "ADD")) {
            bind(MENU_KEY + key, () -> resize(1));
        }
        for (String key : List.of("MINUS", "SUBTRACT")) {
            bind(MENU_KEY + key, () -> resize(-1));
        }
        bind(MENU_KEY + "0", () -> resize(0));
    }

    MessageArea area() {
        return area;
    }

    private void bind(String key, Runnable action) {
        KeyAction.bind(this, WHEN_IN_FOCUSED_WINDOW, KeyStroke.getKeyStroke(key), event -> action.run());
    }

    private void resize(int step) {
        area.text().setLarger(step == 0 ? 0 : area.text().larger() + step);
        keep(SIZE, String.valueOf(area.text().larger()));
    }

    private void keepTimes() {
        keep(TIMES, area.hasTimes() ? "yes" : "no");
    }

    private void keep(String key, String value) {
        EventThread.background("keeping a setting", () -> settings.put(key, value), failed -> {});
    }

    private static int number(String kept) {
        try {
            return Integer.parseInt(kept);
        } catch (NumberFormatException e) {
            return 0;
        }
    }
}
