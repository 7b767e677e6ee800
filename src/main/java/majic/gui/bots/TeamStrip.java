package majic.gui.bots;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.RobotSelection;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.Texts;

/**
 * The team at a glance: a card for each robot, by number. A click selects a robot, Ctrl and a click adds it to the
 * selection or removes it; a right click opens its menu. {@link StripKeys} lists the keys.
 */
public final class TeamStrip extends JPanel implements TeamListener, Scrollable {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(TeamStrip.class);

    /** How often the times on the cards are brought up to date without a report of the robot. */
    private static final int TICK_MS = 500;

    private final transient Team team;
    private final transient RobotSelection selection;
    private final transient RobotActions actions;
    private final transient Consumer<Member> openWindow;
    private final transient CardReader reader;
    private final Timer tick = new Timer(TICK_MS, event -> cards().forEach(RobotCard::update));

    /**
     * Creates cards for the robots that are in the team already; cards for later ones are added by events. The first
     * robot of a team is selected.
     *
     * @param openWindow shows the panel of a robot in a window of its own
     */
    public TeamStrip(Team team, RobotSelection selection, RobotActions actions, Consumer<Member> openWindow) {
        super(new StripLayout());
        HelpTopic.set(this, "selecting-robots");
        this.team = team;
        this.selection = selection;
        this.actions = actions;
        this.openWindow = openWindow;
        reader = new CardReader(team);
        setName("teamStrip");
        getAccessibleContext().setAccessibleName(TEXTS.get("team"));
        selection.addListener(this::showSelection);
        team.members().forEach(this::added);
        setVisible(getComponentCount() > 0);
    }

    @Override
    public void addNotify() {
        super.addNotify();
        reader.start();
        tick.start();
    }

    @Override
    public void removeNotify() {
        tick.stop();
        reader.close();
        super.removeNotify();
    }

    List<RobotCard> cards() {
        return Stream.of(getComponents()).map(RobotCard.class::cast).toList();
    }

    RobotSelection selection() {
        return selection;
    }

    private Optional<RobotCard> card(Member member) {
        return cards().stream().filter(card -> card.member() == member).findFirst();
    }

    /**
     * Adds a card; selects the robot only if it is the only one, because a selected one may be driven at the moment.
     */
    @Override
    public void added(Member member) {
        if (!team.members().contains(member) || card(member).isPresent()) {
            return;
        }
        RobotCard card = new RobotCard(team, member, actions, reader);
        card.setSelected(selection.contains(member));
        Clicks clicks = new Clicks(card);
        card.addMouseListener(clicks);
        card.addFocusListener(clicks);
        int place = (int) cards().stream()
                .filter(other -> other.member().number() < member.number())
                .count();
        add(card, place);
        if (getActionMap().size() == 0) {
            StripKeys.bind(this);
        }
        card.setFocusable(getComponentCount() == 1);
        if (getComponentCount() == 1) {
            selection.select(member);
        }
        cardsChanged();
    }

    @Override
    public void removed(Member member) {
        card(member).ifPresent(card -> {
            card.close();
            remove(card);
            selection.remove(member);
            if (cards().stream().noneMatch(Component::isFocusable)) {
                cards().stream().findFirst().ifPresent(first -> first.setFocusable(true));
            }
            cardsChanged();
        });
    }

    private void cardsChanged() {
        setVisible(getComponentCount() > 0);
        revalidate();
        repaint();
    }

    /** Hides the pane that scrolls the strip together with it. */
    @Override
    public void setVisible(boolean visible) {
        super.setVisible(visible);
        if (SwingUtilities.getAncestorOfClass(StripScroll.class, this) instanceof StripScroll scroll) {
            scroll.setVisible(visible);
        }
    }

    @Override
    public void renamed(Member member) {
        ownerChanged(member);
    }

    @Override
    public void ownerChanged(Member member) {
        card(member).ifPresent(RobotCard::changed);
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        cards().forEach(RobotCard::changed);
    }

    /** Marks the selected robots, and scrolls to the first if none of them is visible; Tab goes to the first. */
    private void showSelection() {
        cards().forEach(card -> card.setSelected(selection.contains(card.member())));
        List<RobotCard> marked = cards().stream().filter(RobotCard::isSelected).toList();
        if (!marked.isEmpty()) {
            if (marked.stream().noneMatch(card -> getVisibleRect().intersects(card.getBounds()))) {
                scrollRectToVisible(marked.get(0).getBounds());
            }
            if (cards().stream().noneMatch(Component::isFocusOwner)) {
                reachByTab(marked.get(0));
            }
        }
    }

    /** Makes a card the only one that Tab reaches. */
    private void reachByTab(RobotCard card) {
        cards().forEach(other -> other.setFocusable(other == card));
    }

    /** Returns by how many cards the one below a card is further. */
    int cardsToNextRow() {
        StripLayout.Grid grid = StripLayout.gridOf(this);
        return grid.isInRows() ? grid.columns() : 1;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return CardSize.BADGE.height(this);
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(visible.height - CardSize.BADGE.height(this), 1);
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    /** Only cards without buttons may be higher together than the visible part. */
    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getComponentCount() == 0
                || StripLayout.gridOf(this).heightOf(getComponentCount())
                        <= getParent().getHeight();
    }

    /** Opens the dialog that renames a robot. */
    void rename(Member member) {
        actions.rename(member, this);
    }

    /**
     * Opens the context menu of a robot.
     *
     * @param on the component that was clicked, and the place in it
     */
    public void showMenu(Member member, Component on, int x, int y) {
        new RobotMenu(member, actions, openWindow).show(on, x, y);
    }

    /** Selects by the mouse, and shows the card that has the focus. The focus stays where it is. */
    private final class Clicks extends MouseAdapter implements FocusListener {
        private final RobotCard card;

        Clicks(RobotCard card) {
            this.card = card;
        }

        @Override
        public void mousePressed(MouseEvent event) {
            if (event.isPopupTrigger()) {
                showMenu(card.member(), card, event.getX(), event.getY());
            } else if (SwingUtilities.isLeftMouseButton(event)) {
                choose(event);
            }
        }

        private void choose(MouseEvent event) {
            if (event.isControlDown() || event.isMetaDown()) {
                selection.toggle(card.member());
            } else {
                selection.select(card.member());
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (event.isPopupTrigger()) {
                showMenu(card.member(), card, event.getX(), event.getY());
            }
        }

        /** Makes the focused card the one that Tab returns to. */
        @Override
        public void focusGained(FocusEvent event) {
            reachByTab(card);
            scrollRectToVisible(card.getBounds());
            card.repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            card.repaint();
        }
    }
}
