package majic.team;

import majic.bot.BotListener;
import majic.bot.MajicBot;

/** Forwards the messages and connection changes of one robot to the team's listeners. */
final class MemberListener implements BotListener {
    private final Team team;
    private final Member member;

    MemberListener(Team team, Member member) {
        this.team = team;
        this.member = member;
    }

    @Override
    public void notice(MajicBot bot, String message) {
        team.tell(listener -> listener.noticed(member.number(), member.number() + ": " + message));
    }

    @Override
    public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
        if (connection == MajicBot.Connection.LOST) {
            bot.lostReason().ifPresent(reason -> team.tell(listener -> listener.lost(member, reason)));
        } else if (connection == MajicBot.Connection.CONNECTED) {
            team.tell(listener -> listener.regained(member));
        }
        team.changes().raise();
    }
}
