package majic.gui.drive;

import java.util.List;
import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.team.Member;
import majic.text.ErrorWords;
import majic.text.Texts;
import majic.time.WaitPolicy;

/** Says in words whether robots that are driven by hand are guarded at the moment, and what holds one of them back. */
final class GuardSign {
    private static final Texts TEXTS = Texts.of(GuardSign.class);

    private GuardSign() {}

    /**
     * Returns what to show.
     *
     * @param chosen whether driving by hand is guarded whatever a robot's own parameter is
     */
    static String text(List<Member> members, boolean chosen) {
        List<Member> guarded = members.stream()
                .filter(member -> chosen || isSetToGuard(member.bot()))
                .toList();
        if (guarded.isEmpty()) {
            return TEXTS.get("guard.off");
        }
        return guarded.stream()
                .flatMap(member -> heldBack(member, members.size() > 1).stream())
                .findFirst()
                .orElseGet(() -> idle(members, guarded));
    }

    private static Optional<String> heldBack(Member member, boolean withNumber) {
        return member.bot()
                .heldBack()
                .map(ErrorWords::of)
                .map(reason -> withNumber ? member.number() + ": " + reason : reason);
    }

    private static String idle(List<Member> members, List<Member> guarded) {
        long able =
                guarded.stream().filter(member -> member.bot().canBeGuarded()).count();
        if (able == 0) {
            return TEXTS.get("guard.none");
        }
        return able == members.size() ? TEXTS.get("guard.on") : TEXTS.get("guard.some", able, members.size());
    }

    private static boolean isSetToGuard(MajicBot bot) {
        return WaitPolicy.without(() -> bot.get("guard").equals(Value.onOff(true)));
    }
}
