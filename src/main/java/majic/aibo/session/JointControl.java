package majic.aibo.session;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majic.aibo.body.Joint;
import majic.aibo.body.Senses;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Motion;

/** Moves joints, and waits until they reach their targets. Only as part of a motion. */
public final class JointControl {
    private static final double LEAST_MS = 100;

    /** A slow engine reports the end two seconds late. */
    private static final double LATE_S = 3;

    /** A joint follows its order with a lag. */
    private static final double SETTLING_S = 0.6;

    private static final double ARRIVED_DEG = 1;

    private final Senses senses;
    private final Supplier<AiboSession> session;

    /** Quick, but not the jerk of a bare assignment. */
    private volatile double degPerSec = 120;

    public JointControl(Senses senses, Supplier<AiboSession> session) {
        this.senses = senses;
        this.session = session;
    }

    /** How fast joints turn that were given no time, deg/s. */
    public double degPerSec() {
        return degPerSec;
    }

    public void setDegPerSec(double newDegPerSec) {
        degPerSec = newDegPerSec;
    }

    /**
     * Turns joints, all in the same time. A leg that was moved is no leg to walk on: the dog stands up before it walks.
     *
     * @param targets the angles, degrees
     * @param givenMs how long it is to take; what the longest way takes if empty
     */
    public void turn(Map<Joint, Double> targets, OptionalDouble givenMs, Motion motion) {
        AiboSession open = session.get();
        open.postures().power(motion);
        double ms = Math.rint(givenMs.orElseGet(() -> usualMs(targets)));
        List<String> commands = targets.entrySet().stream()
                .map(target -> UrbiCommands.assign(target.getKey().urbiName() + ".val", target.getValue()) + " time:"
                        + UrbiVersion.number(ms))
                .toList();
        prepare(open, targets, motion);
        perform(open, commands, ms / 1000, motion);
        motion.await(() -> targets.entrySet().stream().allMatch(this::hasArrived), SETTLING_S);
    }

    private static void prepare(AiboSession open, Map<Joint, Double> targets, Motion motion) {
        Double pan = targets.get(Joint.HEAD_PAN);
        if (pan != null) {
            motion.send(() -> open.sweep().home(pan));
        }
        if (targets.keySet().stream().anyMatch(Joint::isInALeg)) {
            open.dog().setAfoot(false);
        }
    }

    /** Has parts of the dog moved by commands that end by themselves. */
    public void perform(List<String> commands, double seconds, Motion motion) {
        AiboSession open = session.get();
        open.awaitFree(motion);
        perform(open, commands, seconds, motion);
    }

    private static void perform(AiboSession open, List<String> commands, double seconds, Motion motion) {
        RunningMotion running = open.executor().command(open.connections().sensors(), UrbiCommands.together(commands));
        open.postures().perform(motion, running, seconds + LATE_S);
    }

    private double usualMs(Map<Joint, Double> targets) {
        double way = targets.entrySet().stream()
                .collect(Collectors.summarizingDouble(target -> way(target.getKey(), target.getValue())))
                .getMax();
        return Math.max(LEAST_MS, way / degPerSec * 1000);
    }

    private double way(Joint joint, double target) {
        return Math.abs(target - senses.number(joint.sensor()).orElse(0.0));
    }

    private boolean hasArrived(Map.Entry<Joint, Double> target) {
        double measured = senses.number(target.getKey().sensor()).orElse(target.getValue());
        return Math.abs(measured - target.getValue()) < ARRIVED_DEG;
    }
}
