package majic.gui;

import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.Timer;
import majic.environment.Settings;
import majic.gui.bots.RobotTabs;
import majic.gui.kit.BackgroundSettings;

/**
 * Keeps the place and size of the window, whether it is maximised, and its dividers, in the settings, one second after
 * the last change. A window whose screen is gone is shown in the middle of the main screen.
 */
final class FrameMemory {
    private static final String KEY = "window.place";
    private static final int QUIET_MS = 1000;

    private final JFrame frame;
    private final List<JSplitPane> splits;
    private final RobotTabs tabs;
    private final Settings settings;
    private final Timer later = new Timer(QUIET_MS, event -> keep());
    private Rectangle bounds = new Rectangle();
    private String kept = "";

    /**
     * Places the window as it was kept and keeps each change from now on.
     *
     * @param splits the split panes, always in the same order; not laid out yet
     * @param tabs the tabs whose width is kept too
     */
    FrameMemory(JFrame frame, List<JSplitPane> splits, RobotTabs tabs, Settings settings) {
        this.frame = frame;
        this.splits = List.copyOf(splits);
        this.tabs = tabs;
        this.settings = settings;
        later.setRepeats(false);
        WindowPlace.parse(settings.get(KEY).orElse("")).ifPresent(this::restore);
        bounds = frame.getBounds();
        frame.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentMoved(ComponentEvent event) {
                later.restart();
            }

            @Override
            public void componentResized(ComponentEvent event) {
                later.restart();
            }
        });
        frame.addWindowStateListener(event -> later.restart());
        splits.forEach(split ->
                split.addPropertyChangeListener(JSplitPane.DIVIDER_LOCATION_PROPERTY, event -> later.restart()));
        tabs.addPropertyChangeListener(RobotTabs.CHOSEN_WIDTH, event -> later.restart());
    }

    private void restore(WindowPlace place) {
        Rectangle wanted = place.bounds();
        screens().filter(screen -> isUsable(screen, wanted)).findFirst().ifPresent(screen -> {
            frame.setBounds(fitted(wanted, screen));
            restoreDividers(place);
            place.divider(splits.size()).ifPresent(tabs::chooseWidth);
            keepDividersWhileOpening(place);
        });
        if (place.maximised()) {
            frame.setExtendedState(Frame.MAXIMIZED_BOTH);
        }
    }

    /**
     * A window manager may change the size of a new window, by which the dividers would move a little at each start.
     */
    private void keepDividersWhileOpening(WindowPlace place) {
        ComponentAdapter restoring = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                restoreDividers(place);
            }
        };
        splits.forEach(split -> split.addComponentListener(restoring));
        Timer opened = new Timer(QUIET_MS, event -> splits.forEach(split -> split.removeComponentListener(restoring)));
        opened.setRepeats(false);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                opened.start();
            }
        });
    }

    private void restoreDividers(WindowPlace place) {
        for (int index = 0; index < splits.size(); index++) {
            place.divider(index).ifPresent(splits.get(index)::setDividerLocation);
        }
    }

    /** A screen is usable if the middle of the window's top edge, where it can be dragged, is on it. */
    private static boolean isUsable(Rectangle screen, Rectangle wanted) {
        return screen.contains(wanted.x + Math.min(wanted.width, screen.width) / 2, wanted.y + 10);
    }

    private static Rectangle fitted(Rectangle wanted, Rectangle screen) {
        int width = Math.min(wanted.width, screen.width);
        int height = Math.min(wanted.height, screen.height);
        int x = Math.max(screen.x, Math.min(wanted.x, screen.x + screen.width - width));
        int y = Math.max(screen.y, Math.min(wanted.y, screen.y + screen.height - height));
        return new Rectangle(x, y, width, height);
    }

    /** The usable areas of the screens. */
    private static Stream<Rectangle> screens() {
        return Stream.of(GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices())
                .map(GraphicsDevice::getDefaultConfiguration)
                .map(FrameMemory::usable);
    }

    private static Rectangle usable(GraphicsConfiguration screen) {
        Rectangle area = screen.getBounds();
        Insets insets = Toolkit.getDefaultToolkit().getScreenInsets(screen);
        area.x += insets.left;
        area.y += insets.top;
        area.width -= insets.left + insets.right;
        area.height -= insets.top + insets.bottom;
        return area;
    }

    /** Stores the present place. */
    void keep() {
        String text = place().toString();
        if (!text.equals(kept)) {
            kept = text;
            BackgroundSettings.put(settings, KEY, text);
        }
    }

    private WindowPlace place() {
        boolean maximised = (frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH;
        if (!maximised) {
            bounds = frame.getBounds();
        }
        Stream<Integer> dividers = splits.stream().map(FrameMemory::divider);
        return new WindowPlace(
                bounds,
                maximised,
                Stream.concat(dividers, Stream.of(tabs.chosenWidth())).toList());
    }

    /** While panes are compared, the divider is elsewhere than at the next start. */
    private static int divider(JSplitPane split) {
        return split instanceof TeamPane team ? team.usualDividerLocation() : split.getDividerLocation();
    }
}
