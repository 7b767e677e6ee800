package majic.script.actions;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import majic.bot.MajicBot;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;

/** The answer to {@code bots}: the robots and their states. */
final class TeamListing {
    private TeamListing() {}

    static List<String> of(Team team, RobotConnector connector) {
        List<String> lines = new ArrayList<>();
        for (Member member : team.members()) {
            String where =
                    connector.address(member).map(address -> " at " + address).orElse("");
            lines.add(member.number() + ": " + member.label() + where + " " + state(member));
        }
        if (lines.isEmpty()) {
            lines.add("bots: " + team.listing());
        }
        if (team.isLatched()) {
            lines.add("bots: " + team.latchText());
        }
        return lines;
    }

    private static String state(Member member) {
        MajicBot bot = member.bot();
        if (!bot.isConnected()) {
            return bot.connection() == MajicBot.Connection.LOST
                    ? "connection lost"
                    : bot.connection().name().toLowerCase(Locale.ROOT);
        }
        return "connected, " + doing(member);
    }

    private static String doing(Member member) {
        Owner owner = member.owner();
        if (owner != null) {
            return owner.occupationWithValues() + (owner.status().isEmpty() ? "" : ": " + owner.status());
        }
        return member.isIdle() ? "idle" : "busy";
    }
}
