package majic.nav;

import java.util.Optional;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/**
 * Why one robot on its way stands, and for how long it may: until it has made no progress for a time, or has been under
 * way for many times the time that its way should take. Used by the thread that drives the robot.
 */
final class Waiting {
    /** How long something may stand in the way, and how long other robots may be waited for. */
    static final double LONGEST_BLOCKED_S = 20;

    private static final double LONGEST_TRAFFIC_S = 180;

    /** Progress is a way that got shorter by as much, and a new way that is longer by as much begins anew. */
    private static final double PROGRESS_MM = 50;

    private static final double LONGER_MM = 300;
    private static final double LONGEST_WHOLE_S = 300;
    private static final double TIMES_USUAL = 10;

    private final TeamTraffic traffic;
    private final TeamTraffic.Vehicle vehicle;
    private final double begunS;
    private double progressS;

    /** When it was last held up by robots under way: what stands in the way since then has its own time. */
    private double trafficS = Double.NEGATIVE_INFINITY;

    private double longestWholeS = Double.POSITIVE_INFINITY;
    private double leastLeftMm = Double.POSITIVE_INFINITY;
    private String why = "";
    private @Nullable MajicBot before;
    private @Nullable MajicBot passing;
    private String remark = "";

    /** From now on. */
    Waiting(TeamTraffic traffic, TeamTraffic.Vehicle vehicle) {
        this.traffic = traffic;
        this.vehicle = vehicle;
        this.begunS = now();
        this.progressS = begunS;
    }

    private double now() {
        return vehicle.robot().time().nanos() / 1e9;
    }

    /** A way was planned. */
    void planned(double lengthMm, double mmPerSec) {
        leastLeftMm = lengthMm > leastLeftMm + LONGER_MM ? lengthMm : leastLeftMm;
        if (longestWholeS == Double.POSITIVE_INFINITY) {
            longestWholeS = LONGEST_WHOLE_S + TIMES_USUAL * lengthMm / mmPerSec;
        }
    }

    /** So much of the way is left now. */
    void left(double mm) {
        if (mm < leastLeftMm - PROGRESS_MM) {
            leastLeftMm = mm;
            progressS = now();
        }
    }

    /** The robot stands because of another one, or because of what its sensors see if that is null. */
    void standsBehind(@Nullable MajicBot other) {
        before = other;
        passing = null;
        why = (other == null ? "something that its sensors see" : other.name()) + " stands in the way";
    }

    /** Sets what to say beside the reason when it has stood too long; empty for nothing. */
    void remark(String words) {
        remark = words;
    }

    /** The robot stands aside until another one has passed; null if that is not known any more. */
    void standsAsideFor(@Nullable MajicBot other) {
        passing = other;
        why = "it makes room for " + (other == null ? "another robot" : other.name());
    }

    /** The robot drives on. */
    void ends() {
        why = "";
        remark = "";
        before = null;
        passing = null;
        note(false);
    }

    /** Returns why it stands; null if it drives. */
    @Nullable
    Wait reason() {
        return why.isEmpty() ? null : new Wait(why, Optional.ofNullable(passing == null ? before : passing));
    }

    /**
     * Notes in the traffic whether the robot waits for another one.
     *
     * @param stands whether it stands
     * @return for how long it has waited for another robot, s
     */
    double note(boolean stands) {
        return traffic.noteWait(vehicle, stands && before != null);
    }

    /** Whether it may be another robot under way for which it waits. */
    private boolean isInTraffic() {
        MajicBot other = before;
        return other == null ? why.isEmpty() && traffic.isBusy() : traffic.isUnderWay(other);
    }

    /** Fails after a time without progress. */
    void refuseLong(boolean makesRoom) {
        if (makesRoom || isInTraffic()) {
            trafficS = now();
            refuseLonger(LONGEST_TRAFFIC_S, progressS);
        } else {
            refuseLongWithoutWay();
        }
    }

    /** Fails after a time without a way. */
    void refuseLongWithoutWay() {
        refuseLonger(LONGEST_BLOCKED_S, Math.max(progressS, trafficS));
        refuseLonger(LONGEST_TRAFFIC_S, progressS);
    }

    private void refuseLonger(double seconds, double sinceS) {
        String reason = why.isEmpty() ? "it makes no way" : why;
        if (now() - sinceS > seconds) {
            throw new NoWay(reason + " for " + Math.round(seconds) + " s" + (remark.isEmpty() ? "" : "; " + remark));
        }
        if (now() - begunS > longestWholeS) {
            throw new NoWay("it has not arrived after " + Math.round(longestWholeS) + " s; at last, " + reason);
        }
    }
}
