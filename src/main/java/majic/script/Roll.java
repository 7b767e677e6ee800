package majic.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import majic.bot.MajicBot;
import majic.team.Member;
import majic.team.Owner;

/** The answer to {@code bots}: who is here, in which state. */
final class Roll {
    private Roll() {}

    static List<String> of(Session session) {
        List<String> lines = new ArrayList<>();
        for (Member member : session.team().members()) {
            String where = session.comings()
                    .address(member)
                    .map(address -> " at " + address)
                    .orElse("");
            lines.add(member.number() + ": " + member.bot().type().label() + where + " " + state(member));
        }
        if (lines.isEmpty()) {
            lines.add("bots: " + session.team().roll());
        }
        if (session.team().isLatched()) {
            lines.add("bots: STOP is latched; \"release\" allows motion again");
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
            return owner.kind() == Owner.Kind.HAND ? "driven by hand" : "running " + owner.name();
        }
        return member.isIdle() ? "idle" : "busy";
    }
}
