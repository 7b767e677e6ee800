package majic.aibo.session;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import majic.aibo.body.DogState;
import majic.aibo.body.Joint;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiVersion;
import majic.driver.Motion;

/** Moves joints, and waits until they reach their targets. Thread-safe; {@code MajicBot} runs one motion at a time. */
public final class JointControl {
    private static final double LEAST_MS = 100;

    /** A slow engine reports the end two seconds late. */
    private static final double LATE_S = 3;

    /** A joint follows its command with a lag. */
    private static final double ARRIVING_S = 0.6;

    private static final double ARRIVED_DEG = 1;

    private final MotionExecutor executor;
    private final UrbiConnection connection;
    private final PostureControl postures;
    private final HeadSweep sweep;
    private final DogState dog;

    JointControl(
            MotionExecutor executor,
            UrbiConnection connection,
            PostureControl postures,
            HeadSweep sweep,
            DogState dog) {
        this.executor = executor;
        this.connection = connection;
        this.postures = postures;
        this.sweep = sweep;
        this.dog = dog;
    }

    /**
     * Turns joints, all in the same time; blocks until they arrive. After a leg was moved, the dog stands up before it
     * walks.
     *
     * @param targets the angles, degrees
     * @param givenMs how long it takes; if empty, the longest way determines it
     * @param degPerSec the speed of the joint with the longest way, if no time is given
     */
    public void turn(Map<Joint, Double> targets, OptionalDouble givenMs, double degPerSec, Motion motion) {
        postures.power(motion);
        double ms = Math.rint(givenMs.orElseGet(() -> Math.max(LEAST_MS, longestWay(targets) / degPerSec * 1000)));
        List<String> commands = targets.entrySet().stream()
                .map(target -> UrbiCommands.assign(target.getKey().urbiName() + ".val", target.getValue()) + " time:"
                        + UrbiVersion.number(ms))
                .toList();
        prepare(targets, motion);
        send(commands, ms / 1000, motion);
        motion.await(() -> targets.entrySet().stream().allMatch(this::hasArrived), ARRIVING_S);
    }

    private void prepare(Map<Joint, Double> targets, Motion motion) {
        Double pan = targets.get(Joint.HEAD_PAN);
        if (pan != null) {
            motion.send(() -> sweep.home(pan));
        }
        if (targets.keySet().stream().anyMatch(Joint::isInALeg)) {
            dog.setStanding(false);
        }
    }

    /** Moves parts of the dog by commands that end by themselves; blocks until they have ended. */
    public void perform(List<String> commands, double seconds, Motion motion) {
        executor.awaitFree(motion);
        send(commands, seconds, motion);
    }

    private void send(List<String> commands, double seconds, Motion motion) {
        RunningMotion running = executor.command(connection, UrbiCommands.together(commands));
        executor.perform(motion, running, seconds + LATE_S);
    }

    private double longestWay(Map<Joint, Double> targets) {
        return targets.entrySet().stream()
                .mapToDouble(target -> way(target.getKey(), target.getValue()))
                .max()
                .orElse(0);
    }

    private double way(Joint joint, double target) {
        return Math.abs(target - dog.senses().number(joint.sensor()).orElse(0.0));
    }

    private boolean hasArrived(Map.Entry<Joint, Double> target) {
        double measured = dog.senses().number(target.getKey().sensor()).orElse(target.getValue());
        return Math.abs(measured - target.getValue()) < ARRIVED_DEG;
    }
}
