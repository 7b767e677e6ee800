package majic.gui.acts;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import majic.gui.kit.BotStatus;
import majic.gui.kit.Html;
import majic.script.ActOffer;
import majic.team.Member;
import majic.team.Owner;

/**
 * The robots onto each of which the same act is to be loaded. Immutable.
 *
 * @param all one or more
 */
public record LoadTargets(List<LoadTarget> all) {
    static LoadTargets of(List<Member> members) {
        return new LoadTargets(members.stream().map(LoadTarget::of).toList());
    }

    LoadTarget first() {
        return all.get(0);
    }

    /** Returns the question whether to end what runs on the robots; empty if nothing does. */
    Optional<String> question() {
        List<String> busy = all.stream()
                .filter(target -> target.ends() != null)
                .map(target -> running(target.member()))
                .toList();
        if (busy.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of("<html>" + String.join("<br>", busy)
                + (busy.size() == 1
                        ? " End it and load another act?<br>It continues until the new act starts."
                        : "<br>End them and load another act?<br>They continue until the new act starts."));
    }

    private static String running(Member member) {
        Owner lender = member.lender();
        String within = lender == null ? "" : ", part of the script " + Html.escaped(lender.name());
        return "Robot " + member.number() + " is " + Html.escaped(BotStatus.owner(member)) + within + ".";
    }

    /** Returns why one of the robots cannot run an act, as sentences; empty if all can. */
    Optional<String> unfit(ActEntry entry) {
        if (all.size() > 1 && entry.offer() != null && entry.offer().roles().size() > 1) {
            return Optional.of("It needs further robots, so it is loaded onto one robot at a time.");
        }
        return all.stream()
                .flatMap(target -> entry.unfit(target.member()).stream())
                .findFirst();
    }

    /** Returns the command lines that load an act with a single role onto each robot. */
    String lines(ActOffer offer) {
        return all.stream().map(target -> target.lines(offer, List.of())).collect(Collectors.joining("\n"));
    }

    /** Names the robots: {@code robot 2, the Pioneer}. */
    String names() {
        if (all.size() == 1) {
            Member member = first().member();
            return "robot " + member.number() + ", the " + member.bot().type().label();
        }
        return "each of the robots "
                + all.stream().map(target -> "" + target.member().number()).collect(Collectors.joining(", "));
    }
}
