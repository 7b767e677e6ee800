package majic.gui.bots;

import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.SwingUtilities;

/** Selects a robot by the mouse on its tab, and shows which tab has the focus. A click leaves the focus where it is. */
final class TabMouse extends MouseAdapter implements FocusListener {
    private final RobotTabs tabs;
    private final RobotTab tab;

    TabMouse(RobotTabs tabs, RobotTab tab) {
        this.tabs = tabs;
        this.tab = tab;
        tab.addMouseListener(this);
        tab.addFocusListener(this);
    }

    @Override
    public void mousePressed(MouseEvent event) {
        if (event.isPopupTrigger()) {
            tabs.showMenu(tab, tab, event.getX(), event.getY());
        } else if (SwingUtilities.isLeftMouseButton(event)) {
            choose(event);
        }
    }

    private void choose(MouseEvent event) {
        if (event.isControlDown() || event.isMetaDown()) {
            tabs.toggle(tab);
        } else {
            tabs.choose(tab);
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (event.isPopupTrigger()) {
            tabs.showMenu(tab, tab, event.getX(), event.getY());
        }
    }

    /** Makes the focused tab the one that the Tab key returns to. */
    @Override
    public void focusGained(FocusEvent event) {
        tabs.reachByTab(tab);
        tabs.columns().show(List.of(tab));
        tab.repaint();
    }

    @Override
    public void focusLost(FocusEvent event) {
        tab.repaint();
    }
}
