package majic.soak;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import majic.bot.Pose;
import majic.simulation.SimulatedLab;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;

/**
 * Checks that no robot moves from the confirmation of a STOP to its release. It compares where the robots truly are
 * with where they were then. Used by one thread.
 */
final class StopCheck implements TeamListener {
    private static final double MOST_MM = 5;
    private static final double MOST_DEG = 5;

    private final SimulatedLab lab;
    private final Team team;
    private final Consumer<String> problem;
    private final AtomicInteger releases = new AtomicInteger();
    private Map<Integer, Pose> stationary = Map.of();
    private int releasesBefore;

    /** Creates a check of a team of all robots of a lab, in the order of their numbers. */
    StopCheck(SimulatedLab lab, Team team, Consumer<String> problem) {
        this.lab = lab;
        this.team = team;
        this.problem = problem;
        team.addListener(this);
    }

    @Override
    public void latchChanged(boolean latched) {
        releases.addAndGet(latched ? 0 : 1);
    }

    /** Compares with the last call the robots that have confirmed the same STOP since then. */
    void look() {
        int releasesNow = releases.get();
        Map<Integer, Pose> now = team.isLatched() ? confirmed(team.stopStatus()) : new HashMap<>();
        if (releasesNow == releasesBefore) {
            now.replaceAll(this::compare);
        }
        stationary = now;
        releasesBefore = releasesNow;
    }

    /** Where the robots are that have confirmed; none while a confirmation is pending. */
    private Map<Integer, Pose> confirmed(StopStatus status) {
        boolean isPending =
                status.asked() - status.confirmed() != status.unconfirmed().size();
        if (status.asked() == 0 || isPending) {
            return new HashMap<>();
        }
        Map<String, Pose> byName = lab.truePoses();
        Map<Integer, Pose> poses = new HashMap<>();
        for (Member member : team.members()) {
            if (status.problem(member.number()).isEmpty()) {
                poses.put(member.number(), byName.get(lab.robots().get(member.number() - 1)));
            }
        }
        return poses;
    }

    /** Returns where the robot was when it had confirmed. */
    private Pose compare(int robot, Pose now) {
        Pose before = stationary.getOrDefault(robot, now);
        double way = Math.hypot(now.xMm() - before.xMm(), now.yMm() - before.yMm());
        double turn = Math.abs(Math.IEEEremainder(now.headingDeg() - before.headingDeg(), 360));
        if (way > MOST_MM || turn > MOST_DEG) {
            problem.accept("robot " + robot + " moved after it had confirmed a STOP, from " + before + " to " + now);
        }
        return before;
    }
}
