package majicsim.aibo.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.world.Body;
import majicsim.world.Noise;

/**
 * The motion of the body by walking and turning. Nominal: 83.333 mm/s and 36 deg/s at one gait cycle a second (URBI
 * sheet, section 15, calibration); simultaneous walks are averaged, like the commands of the legs. A real dog's steps
 * differ and drift, and backward it is slower; in an exact lab all steps are equal.
 */
public final class Gait {
    static final double MM_PER_CYCLE = 83.333;
    static final double DEG_PER_CYCLE = 36;

    private static final double STEP_SPREAD = 0.05;
    private static final double BACKWARD_SHARE = 0.8;

    private final Body body;
    private final Noise noise;
    private final Legs legs;
    private final BodyOrientation orientation;
    private final double driftDegPerMm;
    private final List<GaitTask> active = new ArrayList<>();
    private double stepFactor = 1;
    private double cycles;

    public Gait(Body body, Legs legs, BodyOrientation orientation, Noise noise) {
        this.body = body;
        this.legs = legs;
        this.orientation = orientation;
        this.noise = noise;
        double side = noise.isExact() ? 0 : noise.chance(0.5) ? 1 : -1;
        driftDegPerMm = side * noise.uniform(3, 5) / 1000;
    }

    Noise noise() {
        return noise;
    }

    void add(GaitTask task) {
        active.add(task);
    }

    void remove(GaitTask task) {
        active.remove(task);
    }

    public boolean isAtRest() {
        return active.isEmpty();
    }

    /** Whether its legs move. */
    public boolean isWalking() {
        return !active.isEmpty() && legs.carry();
    }

    /** Moves the legs; called once a kernel cycle while the dog walks. */
    void swing(GaitTask task, long pass) {
        Map<Variable, Double> angles = legs.swing(task.isTurn(), Math.signum(task.cyclesPerMs()), cycles);
        angles.forEach((joint, degrees) -> joint.submit(degrees, pass));
    }

    /**
     * Sets the body's mean velocity for the lab step that begins now; motions that end within it count in proportion.
     */
    public void drive(double nowMs, double stepMs) {
        double ahead = 0;
        double turn = 0;
        int count = 0;
        for (GaitTask task : active) {
            double share = task.overlapMs(nowMs, stepMs);
            if (share > 0) {
                ahead += task.isTurn() ? 0 : share * task.cyclesPerMs() * MM_PER_CYCLE;
                turn += task.isTurn() ? share * task.cyclesPerMs() * DEG_PER_CYCLE : 0;
                count++;
            }
        }
        boolean moves = count > 0 && legs.carry() && orientation.isUpright();
        double perSec = moves ? 1000 / stepMs / count : 0;
        double mmPerSec = ahead * perSec * stepFactor * (ahead < 0 && !noise.isExact() ? BACKWARD_SHARE : 1);
        body.velocity(mmPerSec, turn * perSec * stepFactor + Math.abs(mmPerSec) * driftDegPerMm);
    }

    /** Counts the gait cycles of the past lab step; each half cycle is a step with its own length. */
    public void count(double fromMs, double stepMs) {
        double before = cycles;
        for (GaitTask task : active) {
            cycles += Math.abs(task.cyclesPerMs()) * task.overlapMs(fromMs, stepMs) / active.size();
        }
        if (Math.floor(2 * before) != Math.floor(2 * cycles)) {
            stepFactor = noise.scale(STEP_SPREAD);
        }
    }
}
