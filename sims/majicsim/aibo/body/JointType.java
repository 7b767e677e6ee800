package majicsim.aibo.body;

import java.util.List;
import java.util.stream.Stream;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.value.Value;

/**
 * A motor of the ERS-7 as the sheet's section 13 lists it.
 *
 * @param restDeg its angle before the motors are switched on
 * @param gains the motor's initial gains
 * @param maxDegPerSec the motor's highest speed; the sheet has no number, these are near those that the maker
 *     recommended
 */
public record JointType(String name, double minDeg, double maxDeg, double restDeg, Gains gains, double maxDegPerSec) {
    /** The factors of a motor's controller. */
    record Gains(double proportional, double integral, double differential) {
        private static final List<Double> SHIFTS = List.of(14.0, 2.0, 15.0);

        /** Makes the fields of a joint; returns the proportional factor, the only one with an effect. */
        Variable install(Variables variables, String joint) {
            Variable factor = new Variable(joint + ".PGain", Value.of(proportional));
            variables.put(factor);
            variables.put(new Variable(joint + ".IGain", Value.of(integral)));
            variables.put(new Variable(joint + ".DGain", Value.of(differential)));
            variables.put(new Variable(joint + ".PShift", Value.of(SHIFTS.get(0))));
            variables.put(new Variable(joint + ".IShift", Value.of(SHIFTS.get(1))));
            variables.put(new Variable(joint + ".DShift", Value.of(SHIFTS.get(2))));
            return factor;
        }
    }

    /** The twelve joints of the legs, in the order of the groups. */
    public static final List<JointType> LEGS = Stream.of("RF", "RH", "LF", "LH")
            .flatMap(leg -> Stream.of(
                    leg.startsWith("R") ? leg(leg, 1, -134, 120) : leg(leg, 1, -120, 134),
                    leg(leg, 2, -9, 91),
                    leg(leg, 3, -29, 119)))
            .toList();

    /** Head and tail. */
    public static final List<JointType> HEAD_AND_TAIL = List.of(
            new JointType("neck", -79, 2, 0, new Gains(14, 1, 2), 180),
            new JointType("headPan", -91, 91, 0, new Gains(8, 2, 1), 570),
            new JointType("headTilt", -16, 44, 0, new Gains(18, 2, 1), 330),
            new JointType("mouth", -58, -3, -3, new Gains(8, 0, 1), 580),
            new JointType("tailPan", -59, 59, 0, new Gains(14, 1, 1), 860),
            new JointType("tailTilt", 2, 63, 2, new Gains(7, 1, 1), 860));

    private static JointType leg(String leg, int joint, double minDeg, double maxDeg) {
        double rest = Posture.LAY.angleDeg(leg.endsWith("F"), joint);
        Gains gains = joint == 2 ? new Gains(10, 1, 1) : new Gains(14, 2, 1);
        double within = Math.max(minDeg, Math.min(maxDeg, rest));
        return new JointType("leg" + leg + joint, minDeg, maxDeg, within, gains, joint == 1 ? 280 : 300);
    }
}
