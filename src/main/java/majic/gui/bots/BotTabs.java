package majic.gui.bots;

import java.awt.CardLayout;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import majic.gui.kit.BotStatus;
import majic.gui.kit.Voice;
import majic.team.Member;
import majic.team.Team;
import majic.team.TeamListener;
import net.miginfocom.swing.MigLayout;

/** A tab for each robot, by number; without robots a word on how to get one. */
public final class BotTabs extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final String NOBODY = "nobody";
    private static final String SOMEBODY = "somebody";

    private final transient Team team;
    private final transient Voice voice;
    private final CardLayout cards = new CardLayout();
    private final JTabbedPane tabs = new JTabbedPane();

    /**
     * Tabs for the robots that are there already; later ones come as news.
     *
     * @param voice how robots and people are spoken to
     */
    public BotTabs(Team team, Voice voice) {
        this.team = team;
        this.voice = voice;
        setLayout(cards);
        tabs.setName("bots");
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        add(hint(), NOBODY);
        add(tabs, SOMEBODY);
        team.members().forEach(this::added);
    }

    private static JPanel hint() {
        JPanel hint = new JPanel(new MigLayout("wrap 1, alignx center, aligny center", "[center]"));
        hint.add(new JLabel("No robots yet."), "gapbottom 12");
        hint.add(new JLabel("Add Bot connects one; the menu Lab"));
        hint.add(new JLabel("starts a simulated lab with three of them."));
        return hint;
    }

    /** The robot whose tab is in front. */
    public Optional<Member> selected() {
        return tabs.getSelectedComponent() instanceof BotPanel panel ? Optional.of(panel.member()) : Optional.empty();
    }

    /** Brings a robot's tab to the front. */
    public void select(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            tabs.setSelectedIndex(index);
        }
    }

    /** The tab in front stays there: somebody may be driving its robot by hand. */
    @Override
    public void added(Member member) {
        if (!team.members().contains(member) || panelAt(member) >= 0) {
            return;
        }
        int place = (int) IntStream.range(0, tabs.getTabCount())
                .filter(index -> panel(index).member().number() < member.number())
                .count();
        BotPanel panel = new BotPanel(team, member, () -> showCondition(member), voice);
        tabs.insertTab("" + member.number(), TabIcon.of(member), panel, tip(member), place);
        cards.show(this, SOMEBODY);
    }

    @Override
    public void removed(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            panel(index).close();
            tabs.removeTabAt(index);
        }
        if (tabs.getTabCount() == 0) {
            cards.show(this, NOBODY);
        }
    }

    @Override
    public void ownerChanged(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            panel(index).news();
        }
    }

    private void showCondition(Member member) {
        int index = panelAt(member);
        if (index >= 0) {
            tabs.setIconAt(index, TabIcon.of(member));
            tabs.setToolTipTextAt(index, tip(member));
        }
    }

    private static String tip(Member member) {
        String make = member.bot().type().label() + " (" + member.bot().type().make() + ")";
        String owner = BotStatus.owner(member);
        return owner.isEmpty() ? make : make + ", " + owner;
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
