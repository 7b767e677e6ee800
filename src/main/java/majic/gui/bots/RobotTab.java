package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.Supplier;
import javax.accessibility.AccessibleAction;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleState;
import javax.accessibility.AccessibleStateSet;
import javax.swing.JLabel;
import javax.swing.UIManager;
import majic.bot.Parameter;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.NumberBadge;
import majic.gui.kit.Palette;
import majic.gui.plot.Plots;
import majic.gui.plot.PlottedPanel;
import majic.panel.BatteryIcon;
import majic.panel.DrawingColors;
import majic.panel.PlotLink;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * The tab of one robot: number, name, state, act, battery and connection, with the buttons that it is given. Shows what
 * {@link #show(RobotSummary)} receives; belongs into {@link RobotTabs}. Must be used on the event dispatch thread.
 */
public final class RobotTab extends PlottedPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RobotTab.class);
    private static final int ARC = 10;
    private static final int LARGE_BADGE = 26;
    private static final int SMALL_BADGE = 18;
    private static final String WIDEST_CHARGE = "100 %";

    private final int number;
    private final transient List<TabButton> buttons;
    private final JLabel badge = new JLabel();
    private final FittedLabel name;
    private final FittedLabel line;
    private final JLabel activity;
    private final JLabel actTime;
    private final JLabel connection = new JLabel();
    private final JLabel battery = new JLabel();
    private TabSize size = TabSize.FULL;
    private transient @Nullable RobotSummary shown;
    private boolean hasBattery;
    private boolean selected;
    private boolean joined;

    /**
     * Creates a tab without buttons that shows the number only.
     *
     * @param number the robot's number
     * @param plots shows curves of the battery
     * @param parameters returns the robot's present parameters
     */
    public RobotTab(int number, Plots plots, Supplier<List<Parameter>> parameters) {
        this(number, plots, parameters, List.of());
    }

    /**
     * Creates a tab that shows the number only.
     *
     * @param buttons what can be done with the robot, placed at the right
     */
    RobotTab(int number, Plots plots, Supplier<List<Parameter>> parameters, List<TabButton> buttons) {
        super(null, plots, number, parameters);
        this.number = number;
        this.buttons = List.copyOf(buttons);
        setName("tab" + number);
        name = new FittedLabel("tabName" + number);
        name.putClientProperty("FlatLaf.style", "font: bold");
        line = new FittedLabel("tabLine" + number);
        activity = new NamedLabel("tabActivity" + number, "");
        actTime = new NamedLabel("tabActTime" + number, "");
        battery.setName("tabBattery" + number);
        battery.setVisible(false);
        PlotLink.install(
                battery,
                List.of(),
                point -> shown == null
                        ? List.of()
                        : List.of(Objects.requireNonNull(shown).battery().parameter()));
        arrange();
    }

    /** Returns the robot's number. */
    public int number() {
        return number;
    }

    /** Shows whether the robot is selected. */
    public void setSelected(boolean isSelected) {
        if (selected != isSelected) {
            selected = isSelected;
            getAccessibleContext()
                    .firePropertyChange(
                            AccessibleContext.ACCESSIBLE_STATE_PROPERTY,
                            isSelected ? null : AccessibleState.SELECTED,
                            isSelected ? AccessibleState.SELECTED : null);
            repaint();
        }
    }

    boolean isSelected() {
        return selected;
    }

    /** Shows whether the pane of the robot is the one beside this tab, which then has no edge towards it. */
    void setJoined(boolean isJoined) {
        if (joined != isJoined) {
            joined = isJoined;
            repaint();
        }
    }

    /** Arranges the parts for another size. */
    void show(TabSize newSize) {
        if (newSize != size) {
            size = newSize;
            arrange();
            showAnew();
        }
    }

    private void arrange() {
        removeAll();
        badge.setIcon(new NumberBadge(number, isWide() ? LARGE_BADGE : SMALL_BADGE));
        line.setIconTextGap(isWide() ? 4 : 3);
        buttons.forEach(button -> button.show(size));
        switch (size) {
            case FULL -> addThreeLines();
            case MEDIUM -> addTwoLines();
            case SMALL -> addTwoShortLines();
            case NARROW -> {
                arrange("insets 0 3 0 2", "[grow]");
                add(badge);
                add(line, "wmin 0, growx, pushx, gapleft 3");
                addButtons(2);
            }
            case BADGE -> {
                arrange("insets 0 3 0 2", "[grow]");
                add(badge);
                add(line, "wmin 0, gapleft 3");
            }
        }
    }

    private boolean isWide() {
        return size == TabSize.FULL || size == TabSize.MEDIUM;
    }

    /** An act's name is cut where there is no room for all of it, its time is not. */
    private void addThreeLines() {
        arrange("insets 4 8 4 6", "[grow][grow][grow]");
        add(badge, "spany 3, aligny center");
        add(name, "spanx 3, wmin 0, gapleft 8");
        add(line, "newline, wmin 0, gapleft 8");
        addMeters();
        add(activity, "newline, spanx 3, split 4, wmin 0, growx 0, gapleft 8");
        add(actTime, "growx, pushx, gapleft 5");
        addButtons(4);
    }

    private void addTwoLines() {
        arrange("insets 3 8 3 6", "[grow][grow]");
        add(badge, "spany 2, aligny center");
        add(name, "wmin 0, gapleft 8");
        addMeters();
        add(line, "newline, spanx 3, split 3, wmin 0, growx, pushx, gapleft 8");
        addButtons(4);
    }

    private void addTwoShortLines() {
        arrange("insets 1 3 1 2", "[grow][grow]");
        add(badge, "spanx 4, split 3");
        add(name, "wmin 0, growx, pushx, gapleft 4");
        add(buttons.isEmpty() ? new JLabel() : buttons.get(buttons.size() - 1), "hmin 16, hmax 100%, gapleft 2");
        add(line, "newline, spanx 4, split 4, wmin 0, growx, pushx, gapleft 4");
        add(connection, "gapleft 2");
        addBattery(3);
        buttons.stream().limit(Math.max(0, buttons.size() - 1)).forEach(button -> add(button, "hmin 16, hmax 100%"));
    }

    private void arrange(String insets, String rows) {
        setLayout(new MigLayout(insets + ", gap 0, hidemode 3, novisualpadding", "[][grow, fill][][][][]", rows));
    }

    private void addMeters() {
        add(connection, "gapleft 6");
        addBattery(6);
    }

    private void addBattery(int gap) {
        add(battery, "gapleft " + gap + (size == TabSize.FULL ? "" : ", wmin " + batteryWidth()));
    }

    private void addButtons(int gap) {
        buttons.forEach(button -> add(button, "hmin 18, hmax 100%, gapleft " + gap));
    }

    /** Shows a state of the robot; has no effect if it is shown already. */
    public void show(RobotSummary now) {
        if (now.equals(shown)) {
            return;
        }
        shown = now;
        name.setWordings(now.names());
        line.setIcon(now.icon());
        line.putClientProperty("FlatLaf.style", now.problem().isEmpty() ? null : "font: bold");
        line.setForeground(now.isUnconfirmed() || now.isLost() ? Palette.error() : null);
        line.setWordings(
                switch (size) {
                    case FULL -> now.conditionLine();
                    case MEDIUM, SMALL -> now.line();
                    case NARROW -> now.onlyLine();
                    case BADGE -> List.of("");
                });
        activity.setText(now.activity());
        actTime.setText(now.actTime());
        showMeters(now);
        describe(now);
        repaint();
    }

    /**
     * Where a name is beside the meters, they keep their place while they have nothing to show, so that it does not
     * change. A problem has their place where the tab is narrow.
     */
    private void showMeters(RobotSummary now) {
        boolean room = size != TabSize.SMALL || now.problem().isEmpty();
        connection.setVisible(room);
        connection.setIcon(new LinkIcon(now.bars()));
        String charge = now.battery().text();
        hasBattery |= !charge.isEmpty();
        battery.setVisible(room && hasBattery);
        battery.setIcon(charge.isEmpty() ? null : new BatteryIcon(now.battery().percent(), false));
        boolean iconAlone = size == TabSize.SMALL && now.battery().percent().isPresent()
                || size == TabSize.FULL && !now.problem().isEmpty();
        battery.setText(iconAlone ? "" : charge);
    }

    /** Returns the width of the widest charge in pixels at the normal font size. */
    private int batteryWidth() {
        int icon = new BatteryIcon(OptionalInt.empty(), false).getIconWidth();
        int text = getFontMetrics(getFont()).stringWidth(WIDEST_CHARGE);
        return UIScale.unscale(size == TabSize.SMALL ? icon : icon + battery.getIconTextGap() + text);
    }

    private void describe(RobotSummary now) {
        setToolTipText(TEXTS.get("tab.tip", now.make(), number, now.description()));
        getAccessibleContext().setAccessibleName(TEXTS.get("tab.name", number, now.description()));
    }

    private void showAnew() {
        RobotSummary last = shown;
        shown = null;
        if (last != null) {
            show(last);
        }
    }

    /** Adapts the colours to the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (line != null) {
            showAnew();
        }
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, 0);
    }

    /** The size depends on the grid of the tabs alone: what a tab shows lays nothing out but the tab. */
    @Override
    public boolean isValidateRoot() {
        return true;
    }

    /**
     * Paints the tab: with a thick frame if selected, open towards its pane if that is beside it, in the alarm colour
     * if a stop is not confirmed.
     */
    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        DrawingColors.prepare(g);
        g.setColor(UIManager.getColor("Panel.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        boolean alarm = shown != null && shown.isUnconfirmed();
        Shape edge = edge(selected || alarm ? 1 : 0.5);
        g.setColor(background());
        g.fill(edge);
        g.setStroke(new BasicStroke(selected || alarm ? 2 : 1));
        g.setColor(alarm ? Palette.error() : selected ? selectedEdge() : UIManager.getColor("Component.borderColor"));
        g.draw(edge);
        if (isFocusOwner()) {
            g.setColor(Palette.text());
            g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {2, 2}, 0));
            g.draw(new RoundRectangle2D.Double(3.5, 3.5, getWidth() - 7, getHeight() - 7, ARC / 2.0, ARC / 2.0));
        }
        g.dispose();
    }

    private Color background() {
        if (joined) {
            return UIManager.getColor("Panel.background");
        }
        return selected
                ? DrawingColors.translucent(UIManager.getColor("Component.accentColor"), 0.16)
                : Palette.paper();
    }

    private Shape edge(double inset) {
        double bottom = getHeight() - inset;
        if (!joined) {
            return new RoundRectangle2D.Double(inset, inset, getWidth() - 2 * inset, bottom - inset, ARC, ARC);
        }
        double arc = ARC / 2.0;
        Path2D open = new Path2D.Double();
        open.moveTo(getWidth(), inset);
        open.lineTo(inset + arc, inset);
        open.quadTo(inset, inset, inset, inset + arc);
        open.lineTo(inset, bottom - arc);
        open.quadTo(inset, bottom, inset + arc, bottom);
        open.lineTo(getWidth(), bottom);
        return open;
    }

    /** Returns the colour of the frame of a selected tab and of the line that joins it to its pane. */
    static Color selectedEdge() {
        return Palette.mixed(Palette.text(), UIManager.getColor("Component.accentColor"), 0.5);
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleTab();
        }
        return accessibleContext;
    }

    /** A page tab that can be selected. */
    private final class AccessibleTab extends AccessibleJPanel implements AccessibleAction {
        private static final long serialVersionUID = 1L;

        @Override
        public AccessibleRole getAccessibleRole() {
            return AccessibleRole.PAGE_TAB;
        }

        @Override
        public AccessibleStateSet getAccessibleStateSet() {
            AccessibleStateSet states = super.getAccessibleStateSet();
            states.add(AccessibleState.SELECTABLE);
            if (selected) {
                states.add(AccessibleState.SELECTED);
            }
            return states;
        }

        @Override
        public AccessibleAction getAccessibleAction() {
            return this;
        }

        @Override
        public int getAccessibleActionCount() {
            return 1;
        }

        @Override
        public @Nullable String getAccessibleActionDescription(int action) {
            return action == 0 ? TEXTS.get("tab.select") : null;
        }

        @Override
        public boolean doAccessibleAction(int action) {
            RobotTabs.of(RobotTab.this).filter(tabs -> action == 0).ifPresent(tabs -> tabs.choose(RobotTab.this));
            return action == 0;
        }

        @Override
        public int getAccessibleIndexInParent() {
            return RobotTabs.of(RobotTab.this)
                    .map(tabs -> tabs.tabs().indexOf(RobotTab.this))
                    .orElse(-1);
        }
    }
}
