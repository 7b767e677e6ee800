package majic.gui.drive;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.gui.kit.BotStatus;
import majic.team.Member;
import majic.team.Owner;
import majic.text.ErrorWords;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Which of some robots can be driven by hand at one moment.
 *
 * @param free the numbers of those that can be, or are
 * @param reasons why the others cannot be, by number
 */
record DriveObstacles(List<Integer> free, Map<Integer, String> reasons) {
    private static final Texts TEXTS = Texts.of(DriveObstacles.class);

    static DriveObstacles of(List<Member> members) {
        List<Integer> free = new ArrayList<>();
        Map<Integer, String> reasons = new LinkedHashMap<>();
        for (Member member : members) {
            String reason = reason(member);
            if (reason == null) {
                free.add(member.number());
            } else {
                reasons.put(member.number(), reason);
            }
        }
        return new DriveObstacles(free, reasons);
    }

    private static @Nullable String reason(Member member) {
        if (member.bot().connection() != MajicBot.Connection.CONNECTED) {
            return BotStatus.condition(member);
        }
        Owner owner = member.owner();
        if (owner != null && owner.kind() == Owner.Kind.MANUAL) {
            return null;
        }
        if (member.isStopLatched()) {
            return TEXTS.get("latched");
        }
        return owner == null ? refusal(member) : TEXTS.get("owned", BotStatus.owner(member), member.number());
    }

    private static @Nullable String refusal(Member member) {
        try {
            member.check(true, null);
            return null;
        } catch (BotException e) {
            return ErrorWords.of(String.valueOf(e.getMessage()));
        }
    }

    boolean someCanBeDriven() {
        return !free.isEmpty();
    }

    /**
     * Returns what to do to drive, or why that is impossible.
     *
     * @param focused whether the keys drive already
     */
    String text(boolean focused) {
        if (free.isEmpty()) {
            return reasons.isEmpty()
                    ? TEXTS.get("noneSelected")
                    : reasons.values().iterator().next();
        }
        return free.size() + reasons.size() == 1
                ? TEXTS.get(focused ? "hold" : "click")
                : TEXTS.get(focused ? "hold.several" : "click.several", names());
    }

    private String names() {
        return free.stream().map(String::valueOf).collect(Collectors.joining(", "));
    }

    /** Returns why robots cannot be driven, each with its number; null if all can be. */
    @Nullable
    String details() {
        return reasons.isEmpty()
                ? null
                : reasons.entrySet().stream()
                        .map(entry -> entry.getKey() + ": " + entry.getValue())
                        .collect(Collectors.joining(";  "));
    }
}
