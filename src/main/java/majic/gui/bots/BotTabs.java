package majic.gui.bots;

import java.awt.CardLayout;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import majic.gui.kit.BotStatus;
import majic.gui.kit.CommandChannel;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import net.miginfocom.swing.MigLayout;

/** Holds a tab for each robot, by number; without robots, a hint on how to add one. */
public final class BotTabs extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final String EMPTY = "no robots";
    private static final String TABS = "robots";

    private final transient Team team;
    private final transient CommandChannel channel;
    private final CardLayout cards = new CardLayout();
    private final JTabbedPane tabs = new JTabbedPane();

    /**
     * Creates tabs for the robots that are in the team already; tabs for later ones are added by events.
     *
     * @param channel submits lines and shows messages
     */
    public BotTabs(Team team, CommandChannel channel) {
        this.team = team;
        this.channel = channel;
        setLayout(cards);
        tabs.setName("bots");
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        add(hint(), EMPTY);
        add(tabs, TABS);
        team.members().forEach(this::added);
    }

    private static JPanel hint() {
        JPanel hint = new JPanel(new MigLayout("wrap 1, alignx center, aligny center", "[center]"));
        hint.add(new JLabel("No robots yet."), "gapbottom 12");
        hint.add(new JLabel("Add Bot connects one; the menu Lab"));
        hint.add(new JLabel("starts a simulated lab with three of them."));
        return hint;
    }

    /** Returns the robot whose tab is selected. */
    public Optional<Member> selected() {
        return tabs.getSelectedComponent() instanceof BotPanel panel ? Optional.of(panel.member()) : Optional.empty();
    }

    /** Selects a robot's tab. */
    public void select(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            tabs.setSelectedIndex(index);
        }
    }

    /** Adds a tab without selecting it, because the robot of the selected tab may be driven manually at the moment. */
    @Override
    public void added(Member member) {
        if (!team.members().contains(member) || panelAt(member) >= 0) {
            return;
        }
        int place = (int) IntStream.range(0, tabs.getTabCount())
                .filter(index -> panel(index).member().number() < member.number())
                .count();
        BotPanel panel = new BotPanel(team, member, () -> showCondition(member), channel);
        tabs.insertTab("" + member.number(), TabIcon.of(member, team.stopStatus()), panel, tip(member), place);
        cards.show(this, TABS);
    }

    @Override
    public void removed(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            panel(index).close();
            tabs.removeTabAt(index);
        }
        if (tabs.getTabCount() == 0) {
            cards.show(this, EMPTY);
        }
    }

    @Override
    public void ownerChanged(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            panel(index).changed();
        }
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        allChanged();
    }

    @Override
    public void latchChanged(boolean latched) {
        allChanged();
    }

    private void allChanged() {
        IntStream.range(0, tabs.getTabCount()).forEach(index -> panel(index).changed());
    }

    private void showCondition(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            tabs.setIconAt(index, TabIcon.of(member, team.stopStatus()));
            tabs.setToolTipTextAt(index, tip(member));
        }
    }

    private String tip(Member member) {
        String make = member.bot().type().label() + " (" + member.bot().type().make() + ")";
        String owner = BotStatus.owner(member);
        String stop = team.stopStatus().problem(member.number()).isPresent() ? ", stop not confirmed" : "";
        return (owner.isEmpty() ? make : make + ", " + owner) + stop;
    }

    private BotPanel panel(int index) {
        return (BotPanel) tabs.getComponentAt(index);
    }

    private int panelAt(Member member) {
        return IntStream.range(0, tabs.getTabCount())
                .filter(index -> panel(index).member() == member)
                .findFirst()
                .orElse(-1);
    }
}
