package majic.gui.acts;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import majic.team.Member;
import majic.team.Owner;

/** The act that runs on a robot, and its running time on the robot's clock. */
public final class RunningAct {
    private final Member member;

    public RunningAct(Member member) {
        this.member = member;
    }

    /** Returns the owner of the robot if it is an act. */
    public Optional<Owner> now() {
        return Optional.ofNullable(member.owner()).filter(owner -> owner.kind() == Owner.Kind.ACT);
    }

    /** Returns the running time as minutes and seconds: {@code 2:05}. */
    public String time() {
        return clock(member.time().secondsSince(member.ownedSinceNanos()));
    }

    static String clock(double seconds) {
        long whole = (long) seconds;
        long minutes = TimeUnit.SECONDS.toMinutes(whole);
        return String.format(Locale.ROOT, "%d:%02d", minutes, whole - TimeUnit.MINUTES.toSeconds(minutes));
    }
}
