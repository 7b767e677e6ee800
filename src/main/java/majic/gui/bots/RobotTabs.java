package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleState;
import javax.accessibility.AccessibleStateSet;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import javax.swing.plaf.UIResource;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * A tab for each robot at the left, in the order of the numbers and in as many columns as needed, and the pane of the
 * selected robot beside them. A click on a tab selects its robot; {@link TabKeys} lists the keys. Must be used on the
 * event dispatch thread.
 */
public class RobotTabs extends JTabbedPane {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RobotTabs.class);
    private static final int USUAL_WIDTH = 284;

    /** The property with the width of the tabs that the user has chosen. */
    public static final String CHOSEN_WIDTH = "chosenWidth";

    private final transient List<RobotTab> tabs = new ArrayList<>();
    private int chosenWidth;
    private int tabsAt;
    private transient @Nullable Footer footer;

    /** Creates it without robots. */
    public RobotTabs(String name) {
        super(LEFT);
        setName(name);
        setFocusable(false);
        getAccessibleContext().setAccessibleName(TEXTS.get("tabs"));
        addChangeListener(event -> selectedIndexChanged());
    }

    /** Installs the layout in columns for the present look and feel. */
    @Override
    public void updateUI() {
        setUI(new RobotTabsUI());
    }

    /** Returns the tabs from the first to the last; unmodifiable. */
    public final List<RobotTab> tabs() {
        return List.copyOf(tabs);
    }

    /** Returns the tabbed pane that a component is in. */
    static Optional<RobotTabs> of(Component part) {
        return Optional.ofNullable((RobotTabs) SwingUtilities.getAncestorOfClass(RobotTabs.class, part));
    }

    /**
     * Adds a tab in the order of the numbers; selects it if it is the first one.
     *
     * @param pane what is shown while the robot is selected
     */
    public final void insert(RobotTab tab, JComponent pane) {
        int place = (int)
                tabs.stream().filter(other -> other.number() <= tab.number()).count();
        if (tabs.isEmpty()) {
            TabKeys.bind(this);
        }
        tabs.add(place, tab);
        new TabMouse(this, tab);
        TabKeys.bind(this, tab);
        insertTab(String.valueOf(tab.number()), null, pane, null, place);
        setTabComponentAt(place, tab);
        tab.getAccessibleContext().setAccessibleParent(this);
        tab.setFocusable(tabs.size() == 1);
        mark(place);
        showMarked();
    }

    /** Removes a tab and its pane; afterwards no other one is selected instead of it. */
    final void remove(RobotTab tab) {
        int place = tabs.indexOf(tab);
        if (getSelectedIndex() == place) {
            setSelectedIndex(-1);
        }
        tabs.remove(place);
        removeTabAt(place);
        if (!tabs.isEmpty() && tabs.stream().noneMatch(Component::isFocusable)) {
            tabs.get(0).setFocusable(true);
        }
        showSelected();
    }

    /** Selects a robot alone, as a click does. */
    void choose(RobotTab tab) {
        setSelectedIndex(tabs.indexOf(tab));
    }

    /** Adds a robot to the selection or removes it, as a click with Ctrl does. */
    void toggle(RobotTab tab) {
        choose(tab);
    }

    /** Selects all robots. */
    void chooseAll() {}

    /** Follows the selected tab; called after each change of it. */
    void selectedIndexChanged() {
        showSelected();
    }

    /** Returns whether a robot is selected. */
    boolean isChosen(RobotTab tab) {
        return tabs.indexOf(tab) == getSelectedIndex();
    }

    /** Opens the dialog that renames a robot, if it can be renamed. */
    void rename(RobotTab tab) {}

    /** Opens the context menu of a robot, if it has one. */
    void showMenu(RobotTab tab, Component on, int x, int y) {}

    /** Marks the selected robots, and scrolls to the first if none of them is visible; Tab goes to the first. */
    final void showSelected() {
        for (int index = 0; index < getTabCount(); index++) {
            mark(index);
        }
        showMarked();
    }

    private void mark(int index) {
        tabs.get(index).setSelected(isChosen(tabs.get(index)));
        getComponentAt(index).setVisible(isShown(index));
    }

    private void showMarked() {
        List<RobotTab> chosen = tabs.stream().filter(RobotTab::isSelected).toList();
        if (!chosen.isEmpty()) {
            columns().show(chosen);
            if (tabs.stream().noneMatch(Component::isFocusOwner)) {
                reachByTab(chosen.get(0));
            }
        }
        revalidate();
        repaint();
    }

    /** Returns whether the pane of a tab is visible. */
    boolean isShown(int index) {
        return index == getSelectedIndex();
    }

    /** Makes a tab the only one that the Tab key reaches. */
    final void reachByTab(RobotTab tab) {
        tabs.forEach(other -> other.setFocusable(other == tab));
    }

    final RobotTabsUI columns() {
        return (RobotTabsUI) getUI();
    }

    /** Returns the width of all columns of tabs in pixels; less are shown where there is no room for so much. */
    public final int widthOfTabs() {
        return chosenWidth > 0 ? chosenWidth : UIScale.scale(USUAL_WIDTH);
    }

    /**
     * Moves the tabs to the right, so that there is room for a second pane at their left; where it is too narrow, two
     * panes are both at their right.
     *
     * @param pixels the room, 0 for none
     */
    public final void placeTabs(int pixels) {
        if (tabsAt != pixels) {
            tabsAt = pixels;
            revalidate();
            repaint();
        }
    }

    final int tabsAt() {
        return tabsAt;
    }

    /** Returns the width at the right of the tabs, in pixels. */
    public final int widthOfPanes() {
        return getWidth() - columns().placeOfPanes().x;
    }

    /** Returns the width in pixels that the user has chosen; 0 if none. */
    public final int chosenWidth() {
        return chosenWidth;
    }

    /** Changes the width of all columns of tabs to so many pixels; 0 for the usual width. */
    public final void chooseWidth(int pixels) {
        int before = chosenWidth;
        chosenWidth = pixels;
        firePropertyChange(CHOSEN_WIDTH, before, pixels);
        revalidate();
        repaint();
    }

    /** Shows components below the panes, one above the other; once. */
    final void setFooter(JComponent upper, JComponent lower) {
        Footer below = new Footer();
        below.add(upper, BorderLayout.NORTH);
        below.add(lower, BorderLayout.CENTER);
        footer = below;
        add(below);
    }

    final @Nullable JComponent footer() {
        return footer;
    }

    /** Returns the tool tip of the tab, which begins with the make of the robot. */
    @Override
    public @Nullable String getToolTipTextAt(int index) {
        return tabs.get(index).getToolTipText();
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleTabs();
        }
        return accessibleContext;
    }

    /** What is below the panes. Without its type, it would get a tab. */
    private static final class Footer extends JPanel implements UIResource {
        private static final long serialVersionUID = 1L;

        Footer() {
            super(new BorderLayout());
        }
    }

    /** A page tab list, whose children are the tabs, in which several can be selected. */
    private final class AccessibleTabs extends AccessibleJTabbedPane {
        private static final long serialVersionUID = 1L;

        private List<RobotTab> chosen() {
            return tabs.stream().filter(RobotTab::isSelected).toList();
        }

        @Override
        public AccessibleStateSet getAccessibleStateSet() {
            AccessibleStateSet states = super.getAccessibleStateSet();
            states.add(AccessibleState.MULTISELECTABLE);
            return states;
        }

        @Override
        public int getAccessibleChildrenCount() {
            return tabs.size() + others().size();
        }

        @Override
        public @Nullable Accessible getAccessibleChild(int index) {
            if (index < tabs.size()) {
                return tabs.get(index);
            }
            List<Accessible> others = others();
            return index - tabs.size() < others.size() ? others.get(index - tabs.size()) : null;
        }

        /** Returns the visible panes, and what is below them. */
        private List<Accessible> others() {
            List<Accessible> others = new ArrayList<>();
            IntStream.range(0, getTabCount())
                    .mapToObj(RobotTabs.this::getComponentAt)
                    .filter(Component::isVisible)
                    .forEach(pane -> others.add((Accessible) pane));
            if (footer != null) {
                others.add(footer);
            }
            return others;
        }

        @Override
        public int getAccessibleSelectionCount() {
            return chosen().size();
        }

        @Override
        public @Nullable Accessible getAccessibleSelection(int index) {
            List<RobotTab> chosen = chosen();
            return index < chosen.size() ? chosen.get(index) : null;
        }

        @Override
        public boolean isAccessibleChildSelected(int index) {
            return index < tabs.size() && tabs.get(index).isSelected();
        }

        @Override
        public void addAccessibleSelection(int index) {
            if (index < tabs.size() && !isAccessibleChildSelected(index)) {
                toggle(tabs.get(index));
            }
        }

        @Override
        public void removeAccessibleSelection(int index) {
            if (index < chosen().size()) {
                toggle(chosen().get(index));
            }
        }

        @Override
        public void clearAccessibleSelection() {
            chosen().forEach(RobotTabs.this::toggle);
        }

        @Override
        public void selectAllAccessibleSelection() {
            chooseAll();
        }
    }
}
