package majicsim.aibo.body;

import java.util.List;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.value.Value;

/** The factors of a motor's controller (URBI sheet, section 13). */
record MotorGains(double proportional, double integral, double differential) {
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
