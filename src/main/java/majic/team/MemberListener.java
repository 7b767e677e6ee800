package majic.team;

import majic.bot.MajicBot;
import majic.driver.EventOnlyListener;

/** Forwards the messages and connection changes of one robot to the team's listeners. */
final class MemberListener implements EventOnlyListener {
    private final TeamEvents events;
    private final Member member;
    private final StopSender stops;

    MemberListener(TeamEvents events, Member member, StopSender stops) {
        this.events = events;
        this.member = member;
        this.stops = stops;
    }

    @Override
    public void notice(MajicBot bot, String message) {
        events.publish(listener -> listener.noticed(member.number(), member.number() + ": " + message));
    }

    @Override
    public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
        if (connection == MajicBot.Connection.LOST) {
            bot.lostReason().ifPresent(reason -> events.publish(listener -> listener.lost(member, reason)));
        } else if (connection == MajicBot.Connection.CONNECTED) {
            events.publish(listener -> listener.regained(member));
            stops.regained(member);
        }
        events.changes().raise();
    }
}
