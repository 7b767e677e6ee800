package majic.gui.acts;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import majic.gui.kit.BotStatus;
import majic.team.Member;
import majic.team.Owner;
import org.jspecify.annotations.Nullable;

/**
 * The act that runs on a robot, and its running time on the robot's clock, measured from the first {@link #update()} that
 * finds it. Must be used on one thread.
 */
public final class RunningAct {
    private final Member member;
    private @Nullable Owner act;
    private long beganNanos;

    public RunningAct(Member member) {
        this.member = member;
    }

    /** Looks for an act now; returns the owner of the robot if it is an act. */
    public Optional<Owner> update() {
        Owner owner = member.owner();
        if (owner == null || !BotStatus.isInAct(member)) {
            act = null;
        } else if (owner != act) {
            act = owner;
            beganNanos = member.time().nanos();
        }
        return Optional.ofNullable(act);
    }

    /** Returns the running time as minutes and seconds: {@code 02:05}. */
    public String time() {
        return clock(member.time().secondsSince(beganNanos));
    }

    static String clock(double seconds) {
        long whole = (long) seconds;
        long minutes = TimeUnit.SECONDS.toMinutes(whole);
        return String.format(Locale.ROOT, "%02d:%02d", minutes, whole - TimeUnit.MINUTES.toSeconds(minutes));
    }
}
