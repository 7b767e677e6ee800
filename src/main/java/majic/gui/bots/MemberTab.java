package majic.gui.bots;

import java.util.List;
import majic.gui.acts.RunningAct;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;

/**
 * Keeps the tab of a robot of the team up to date, and stops and reconnects the robot by the buttons of the tab.
 * Listens to the robot until {@link #close()}. Must be used on the event dispatch thread unless stated otherwise.
 */
final class MemberTab {
    private static final Texts TEXTS = Texts.of(MemberTab.class);

    private final Team team;
    private final Member member;
    private final RobotActions actions;
    private final SummaryReader reader;
    private final RunningAct act;
    private final LinkMeter link = new LinkMeter();
    private final TabButton reconnect;
    private final RobotTab tab;
    private final MemberRefresh refresh;

    MemberTab(Team team, Member member, RobotActions actions, SummaryReader reader) {
        this.team = team;
        this.member = member;
        this.actions = actions;
        this.reader = reader;
        act = new RunningAct(member);
        int number = member.number();
        reconnect = new TabButton(
                "tabReconnect" + number,
                TEXTS.get("tab.reconnect"),
                ActionIcon.RECONNECT,
                TEXTS.get("tab.reconnect.tip", number));
        reconnect.addActionListener(event -> {
            reconnect.setEnabled(false);
            actions.reconnect(member, () -> reconnect.setEnabled(true));
        });
        TabButton stop = new TabButton(
                "tabStop" + number, TEXTS.get("tab.stop"), ActionIcon.STOP, TEXTS.get("tab.stop.tip", number));
        stop.addActionListener(event -> actions.stop(member));
        tab = new RobotTab(number, actions.plots(), member.bot()::parameters, List.of(reconnect, stop));
        update();
        refresh = new MemberRefresh(member, this::update);
    }

    Member member() {
        return member;
    }

    RobotTab tab() {
        return tab;
    }

    /** Schedules an update; callable from any thread. */
    void changed() {
        refresh.changed();
    }

    /** Removes the listener. */
    void close() {
        refresh.close();
    }

    /** Shows the state of the robot. */
    void update() {
        RobotSummary now = RobotSummary.of(member, team.stopStatus(), act, link, reader.readings(member), countdown());
        reconnect.setVisible(now.isLost());
        tab.show(now);
    }

    private String countdown() {
        return actions.attempts(member).map(ReconnectCountdown::shortText).orElse("");
    }
}
