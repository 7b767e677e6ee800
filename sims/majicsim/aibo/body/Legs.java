package majicsim.aibo.body;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Variable;

/** The twelve joints of the legs together: the commands of a gait, whether they carry the body, and their posture. */
public final class Legs {
    /** The share of the legs' stiffness that is needed to stand. */
    private static final double CARRYING_LOAD = 0.5;

    private static final double GUESS_TOLERANCE_DEG = 12;
    /** The squared error in degrees within which a posture counts as reached, so that the blend stays finite. */
    private static final double CLOSE_SQUARE_DEG = 0.1;

    private static final double LIFTING_DEG = 12;
    private static final double GAIT_TOLERANCE_DEG = 35;
    private static final double SECOND_HARMONIC = 0.2;
    private static final double[][] WALK_SWING_DEG = {{29, 4.4, 27}, {29, 4.7, 23}};
    private static final double[][] TURN_SWING_DEG = {{15, 16, 22}, {12, 13, 21}};
    private static final double[][] TURN_MEAN_DEG = {{-19.4, 17.8, 82.2}, {-20.0, 12.8, 89.3}};

    private final List<Joint> joints;
    private double[] shouldersOfDeg = {};
    private ShoulderPose shoulders = new ShoulderPose(0, 0);

    public Legs(List<Joint> joints) {
        this.joints = joints;
    }

    /** Whether the motors are stiff enough for the gait to move the body. */
    boolean carry() {
        return joints.stream().mapToDouble(Joint::stiffness).average().orElse(0) >= CARRYING_LOAD;
    }

    /** The commands of a gait: first and second harmonic about its mean (URBI sheet, section 15). */
    Map<Variable, Double> swing(boolean turn, double direction, double cycles) {
        Map<Variable, Double> angles = new HashMap<>();
        for (Joint joint : joints) {
            int row = isFront(joint) ? 0 : 1;
            int column = number(joint) - 1;
            double mean = turn ? TURN_MEAN_DEG[row][column] : Posture.WALKING.angleDeg(row == 0, column + 1);
            double swing = (turn ? TURN_SWING_DEG : WALK_SWING_DEG)[row][column];
            double phase = 2 * Math.PI * (direction * cycles + shift(joint, row) + 0.25 * column);
            double wave = Math.sin(phase) + SECOND_HARMONIC * Math.sin(2 * phase);
            angles.put(joint.angle(), mean + swing * wave / (1 + SECOND_HARMONIC));
        }
        return angles;
    }

    /** Whether the knee of a leg, such as LF, is bent further than any standing posture has it. */
    boolean isLifted(String leg) {
        String knee = "leg" + leg + "3";
        return joints.stream()
                .filter(joint -> joint.type().name().equals(knee))
                .anyMatch(joint -> joint.degrees() > Posture.WALKING.angleDeg(isFront(joint), 3) + LIFTING_DEG);
    }

    /** {@code stand}, {@code sit}, {@code lay} or {@code unknown}, by the measured angles. */
    String guess() {
        for (Posture posture : Posture.values()) {
            double tolerance = posture == Posture.WALKING ? GAIT_TOLERANCE_DEG : GUESS_TOLERANCE_DEG;
            if (joints.stream().allMatch(joint -> isNear(joint, posture, tolerance))) {
                return posture.guess();
            }
        }
        return "unknown";
    }

    /**
     * The height and pitch of the front of the body: a mean of those of the postures, weighted by how near their angles
     * are.
     */
    ShoulderPose shoulders() {
        double[] anglesDeg = joints.stream().mapToDouble(Joint::degrees).toArray();
        if (!Arrays.equals(anglesDeg, shouldersOfDeg)) {
            shouldersOfDeg = anglesDeg;
            shoulders = meanShoulders();
        }
        return shoulders;
    }

    private ShoulderPose meanShoulders() {
        double weights = 0;
        double shoulderMm = 0;
        double pitchDeg = 0;
        for (Posture posture : Posture.values()) {
            double weight = 1 / (distance(posture) + CLOSE_SQUARE_DEG);
            weights += weight * weight;
            shoulderMm += weight * weight * posture.shoulders().shoulderMm();
            pitchDeg += weight * weight * posture.shoulders().pitchDeg();
        }
        return new ShoulderPose(shoulderMm / weights, pitchDeg / weights);
    }

    /** Mean square of the angles to a posture. */
    private double distance(Posture posture) {
        return joints.stream()
                .mapToDouble(joint -> joint.degrees() - reachable(joint, posture))
                .map(error -> error * error)
                .average()
                .orElse(0);
    }

    private static double reachable(Joint joint, Posture posture) {
        double asked = posture.angleDeg(isFront(joint), number(joint));
        return Math.max(joint.type().minDeg(), Math.min(joint.type().maxDeg(), asked));
    }

    private static boolean isNear(Joint joint, Posture posture, double toleranceDeg) {
        return Math.abs(joint.degrees() - reachable(joint, posture)) <= toleranceDeg;
    }

    /** Left and right go in antiphase, and so do front and hind of one side. */
    private static double shift(Joint joint, int row) {
        boolean left = joint.type().name().startsWith("legL");
        return (left ? 0.5 : 0) + (row == 1 ? 0.5 : 0);
    }

    private static boolean isFront(Joint joint) {
        return joint.type().name().charAt(4) == 'F';
    }

    private static int number(Joint joint) {
        return joint.type().name().charAt(5) - '0';
    }
}
