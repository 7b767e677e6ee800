package majic.gui.bots;

import com.formdev.flatlaf.ui.FlatTabbedPaneUI;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.LayoutManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseListener;
import java.awt.event.MouseWheelEvent;
import java.awt.event.MouseWheelListener;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JScrollBar;
import javax.swing.plaf.UIResource;

/**
 * Places the tabs of robots in columns at the left by a {@link TabGrid}, scrolls those for which there is no room, and
 * draws the line that joins the selected tab to its pane. The right edge of the columns can be dragged. Of two visible
 * panes, the one of the selected tab is at the right of the tabs, and the other one at their left if there is room, so
 * that the tabs need not move. The tabs paint themselves and handle mouse and keys themselves.
 */
final class RobotTabsUI extends FlatTabbedPaneUI {
    /** Width in pixels between the tabs and the panes. */
    private static final int GUTTER = 8;

    private static final int LINE = 2;
    private static final int WHEEL_STEP = 40;

    private static final Dimension PANE = new Dimension(470, 400);
    private static final Dimension LEAST_PANE = new Dimension(360, 200);

    /** Pixels of a pane that remain however far the edge of the tabs is dragged. */
    private static final int LEAST_LEFT = 120;

    private final Scroll scroll = new Scroll();
    private final Grip grip = new Grip();
    private final MouseWheelListener wheel = this::turned;
    private List<RobotTab> toShow = List.of();
    private TabGrid grid = new TabGrid(1, 1, TabSize.FULL, 0, 0);

    /** Returns the present places of the tabs. */
    TabGrid grid() {
        return grid;
    }

    private RobotTabs pane() {
        return (RobotTabs) tabPane;
    }

    @Override
    protected void installComponents() {
        super.installComponents();
        tabPane.add(scroll);
        tabPane.add(grip);
    }

    @Override
    protected void uninstallComponents() {
        tabPane.remove(scroll);
        tabPane.remove(grip);
        super.uninstallComponents();
    }

    @Override
    protected void installListeners() {
        super.installListeners();
        tabPane.addMouseWheelListener(wheel);
    }

    @Override
    protected void uninstallListeners() {
        tabPane.removeMouseWheelListener(wheel);
        super.uninstallListeners();
    }

    /** The tabs have keys of their own. */
    @Override
    protected void installKeyboardActions() {}

    @Override
    protected void uninstallKeyboardActions() {}

    @Override
    protected MouseListener createMouseListener() {
        return new MouseAdapter() {};
    }

    @Override
    protected void setRolloverTab(int x, int y) {}

    @Override
    protected LayoutManager createLayoutManager() {
        return new Columns();
    }

    private void turned(MouseWheelEvent event) {
        if (area().contains(event.getPoint())) {
            scroll.setValue(scroll.getValue() + (int) Math.round(event.getPreciseWheelRotation() * WHEEL_STEP));
        }
    }

    /** Scrolls to the first of some tabs if none of them is visible. */
    void show(List<RobotTab> tabs) {
        toShow = List.copyOf(tabs);
        tabPane.revalidate();
    }

    private void scrollToWanted(List<RobotTab> tabs, int visible) {
        List<Rectangle> places = toShow.stream()
                .map(tabs::indexOf)
                .filter(index -> index >= 0)
                .map(grid::place)
                .toList();
        toShow = List.of();
        int top = scroll.getValue();
        if (places.stream().noneMatch(place -> place.y >= top && place.y + place.height <= top + visible)) {
            places.stream()
                    .findFirst()
                    .ifPresent(place -> scroll.setValue(place.y < top ? place.y : place.y + place.height - visible));
        }
    }

    /** Returns the width at the left of the tabs for a second pane; 0 where both panes are at the right. */
    private int left() {
        int most = tabPane.getWidth() - TabSize.BADGE.width() - GUTTER - UIScale.scale(LEAST_LEFT);
        int left = Math.min(pane().tabsAt(), most);
        return left < UIScale.scale(LEAST_LEFT) ? 0 : left;
    }

    private int widthOfTabs() {
        int most = Math.max(TabSize.BADGE.width(), tabPane.getWidth() - left() - GUTTER - UIScale.scale(LEAST_LEFT));
        return Math.max(TabSize.BADGE.width(), Math.min(pane().widthOfTabs(), most));
    }

    /** Returns where the panes begin. */
    Point placeOfPanes() {
        return new Point(left() + widthOfTabs() + GUTTER, 0);
    }

    @Override
    public void paint(Graphics graphics, JComponent component) {
        int selected = tabPane.getSelectedIndex();
        if (selected < 0) {
            return;
        }
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(RobotTab.selectedEdge());
        int edge = placeOfPanes().x - LINE;
        // Lays the tabs out first if they are not: a window may paint before it validates, as at a change of the look.
        Rectangle tab = getTabBounds(tabPane, selected).intersection(area());
        if (grid.isBesidePanes(selected) && !tab.isEmpty()) {
            g.fillRect(edge, 0, LINE, tab.y + LINE);
            g.fillRect(edge, tab.y + tab.height - LINE, LINE, tabPane.getHeight() - tab.y - tab.height + LINE);
            g.fillRect(tab.x + tab.width, tab.y, edge - tab.x - tab.width, LINE);
            g.fillRect(tab.x + tab.width, tab.y + tab.height - LINE, edge - tab.x - tab.width, LINE);
        } else {
            g.fillRect(edge, 0, LINE, tabPane.getHeight());
            if (!tab.isEmpty()) {
                g.fillRect(
                        tab.x + tab.width - 2 * LINE,
                        tab.y + tab.height + 1,
                        edge - tab.x - tab.width + 2 * LINE,
                        LINE);
            }
        }
        g.dispose();
    }

    /** Returns the place of all tabs that are visible. */
    private Rectangle area() {
        return new Rectangle(left(), 0, widthOfTabs(), tabPane.getHeight());
    }

    /** Places tabs, panes and what is below them. */
    private final class Columns extends TabbedPaneLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            return size(UIScale.scale(PANE));
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return size(UIScale.scale(LEAST_PANE));
        }

        private Dimension size(Dimension panes) {
            return new Dimension(pane().widthOfTabs() + GUTTER + panes.width, panes.height);
        }

        @Override
        public void calculateLayoutInfo() {
            layoutContainer(tabPane);
        }

        @Override
        public void layoutContainer(Container parent) {
            layoutTabs();
            int left = placeOfPanes().x;
            grip.setBounds(left - GUTTER, 0, GUTTER, tabPane.getHeight());
            int width = Math.max(0, tabPane.getWidth() - left);
            int bottom = tabPane.getHeight();
            JComponent footer = pane().footer();
            if (footer != null) {
                int height = Math.min(footer.getPreferredSize().height, bottom);
                bottom -= height;
                footer.setBounds(left, bottom, width, height);
            }
            layoutPanes(new Rectangle(left, 0, width, bottom));
        }

        private void layoutTabs() {
            List<RobotTab> tabs = pane().tabs();
            assureRectsCreated(tabs.size());
            runCount = 1;
            if (tabs.isEmpty()) {
                scroll.setVisible(false);
                return;
            }
            Rectangle area = area();
            grid = TabGrid.of(tabs.size(), area.getSize(), tabPane);
            boolean scrolls = grid.heightOfAll() > area.height;
            if (scrolls) {
                area.width -= scroll.getPreferredSize().width;
                grid = TabGrid.of(tabs.size(), area.getSize(), tabPane);
            }
            scroll.setVisible(scrolls);
            scroll.setBounds(area.x + area.width, 0, scroll.getPreferredSize().width, area.height);
            scroll.show(scrolls ? grid.heightOfAll() : area.height, area.height);
            scrollToWanted(tabs, area.height);
            placeTabs(tabs, area);
        }

        private void placeTabs(List<RobotTab> tabs, Rectangle area) {
            tabs.stream()
                    .map(Component::getParent)
                    .filter(Objects::nonNull)
                    .findFirst()
                    .ifPresent(container -> container.setBounds(area));
            for (int index = 0; index < tabs.size(); index++) {
                RobotTab tab = tabs.get(index);
                Rectangle place = grid.place(index);
                place.translate(0, -scroll.getValue());
                rects[index] = new Rectangle(place);
                rects[index].translate(area.x, 0);
                tab.show(grid.size());
                tab.setJoined(index == tabPane.getSelectedIndex() && grid.isBesidePanes(index) && !scroll.isVisible());
                if (!tab.getBounds().equals(place)) {
                    tab.setBounds(place);
                    tab.validate();
                }
            }
        }

        private void layoutPanes(Rectangle room) {
            List<Component> panes = IntStream.range(0, tabPane.getTabCount())
                    .mapToObj(tabPane::getComponentAt)
                    .filter(Component::isVisible)
                    .toList();
            if (panes.size() == 2 && left() > 0) {
                Component selected = tabPane.getSelectedComponent();
                panes.forEach(pane -> pane.setBounds(
                        pane == selected ? room : new Rectangle(0, 0, left() - GUTTER, tabPane.getHeight())));
                return;
            }
            for (int index = 0; index < panes.size(); index++) {
                int left = room.x + room.width * index / panes.size();
                int right = room.x + room.width * (index + 1) / panes.size();
                panes.get(index).setBounds(left, room.y, right - left, room.height);
            }
        }
    }

    /** Scrolls the tabs. */
    private final class Scroll extends JScrollBar implements UIResource {
        private static final long serialVersionUID = 1L;

        Scroll() {
            super(VERTICAL);
            setName("tabScroll");
            setUnitIncrement(WHEEL_STEP);
            setFocusable(false);
            addAdjustmentListener(event -> {
                tabPane.revalidate();
                tabPane.repaint(area());
            });
        }

        void show(int all, int visible) {
            setBlockIncrement(visible);
            int value = Math.max(0, Math.min(getValue(), all - visible));
            if (getMaximum() != all || getVisibleAmount() != visible || value != getValue()) {
                setValues(value, visible, 0, all);
            }
        }
    }

    /** The right edge of the tabs, which can be dragged. */
    private final class Grip extends JComponent implements UIResource {
        private static final long serialVersionUID = 1L;

        Grip() {
            setName("tabGrip");
            setCursor(Cursor.getPredefinedCursor(Cursor.E_RESIZE_CURSOR));
            addMouseMotionListener(new MouseAdapter() {
                @Override
                public void mouseDragged(MouseEvent event) {
                    int most = tabPane.getWidth() - left() - GUTTER - UIScale.scale(LEAST_LEFT);
                    int wanted = getX() - left() + event.getX() - GUTTER / 2;
                    pane().chooseWidth(Math.max(TabSize.BADGE.width(), Math.min(wanted, most)));
                }
            });
        }
    }
}
