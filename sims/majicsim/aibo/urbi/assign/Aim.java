package majicsim.aibo.urbi.assign;

import majicsim.aibo.urbi.memory.Properties;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.value.Failure;

/**
 * Where an assignment of a number goes, and how. Immutable.
 *
 * @param target in the variable's own unit, not yet clipped
 * @param modifiers in that unit too
 */
record Aim(double target, Modifiers modifiers) {
    /** The aim as it was written; a normalised one is brought into the variable's unit (URBI sheet, section 5). */
    static Aim of(Action.Assign assignment, Variable variable, double value, Modifiers modifiers) throws Failure {
        if (!assignment.target().suffix().equals("'n")) {
            return new Aim(value, modifiers);
        }
        Properties properties = variable.properties();
        double target = properties.denormalize(variable.name(), Math.max(0, Math.min(1, value)));
        return new Aim(target, modifiers.scaled(properties.range()));
    }
}
