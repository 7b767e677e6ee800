package majic.gui.acts;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import majic.team.Member;
import majic.text.NumberList;
import majic.text.Texts;

/**
 * The robots onto each of which the same act is to be loaded. Immutable.
 *
 * @param all one or more
 */
public record LoadTargets(List<LoadTarget> all) {
    private static final Texts TEXTS = Texts.of(LoadTargets.class);

    static LoadTargets of(List<Member> members) {
        return new LoadTargets(members.stream().map(LoadTarget::of).toList());
    }

    LoadTarget first() {
        return all.get(0);
    }

    /** Returns the question whether to end what runs on the robots; empty if nothing does. */
    Optional<String> question() {
        List<String> busy = all.stream()
                .flatMap(target ->
                        Optional.ofNullable(target.ends())
                                .map(owner -> LoadTarget.occupation(target.member(), owner))
                                .stream())
                .toList();
        if (busy.isEmpty()) {
            return Optional.empty();
        }
        String question = TEXTS.get(busy.size() == 1 ? "replaceOne" : "replaceSeveral");
        return Optional.of(String.join("\n", busy) + "\n" + question);
    }

    /** Returns why one of the robots cannot run an act, as sentences; empty if all can. */
    Optional<String> unfit(ActEntry entry) {
        if (all.size() > 1 && entry.offer() != null && entry.offer().roles().size() > 1) {
            return Optional.of(TEXTS.get("oneAtATime"));
        }
        return all.stream()
                .flatMap(target -> entry.unfit(target.member()).stream())
                .findFirst();
    }

    /** Returns the command lines that load an act with a single role onto each robot. */
    String lines(ChosenAct act) {
        return all.stream().map(target -> target.lines(act, List.of())).collect(Collectors.joining("\n"));
    }

    /** Returns the heading above acts for the robots: {@code An act for robot 2, the Pioneer}. */
    String heading() {
        if (all.size() == 1) {
            Member member = first().member();
            return TEXTS.get("actForOne", member.number(), member.bot().kind());
        }
        return TEXTS.get(
                "actForEach",
                NumberList.of(
                        all.stream().map(target -> target.member().number()).toList()));
    }
}
