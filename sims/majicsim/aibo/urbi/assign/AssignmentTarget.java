package majicsim.aibo.urbi.assign;

import majicsim.aibo.urbi.memory.Properties;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.value.Failure;

/**
 * The number that an assignment writes, with its modifiers. Immutable.
 *
 * @param target in the variable's own unit, not yet clipped
 * @param modifiers in the same unit
 */
record AssignmentTarget(double target, Modifiers modifiers) {
    /** The target as it was written; a normalised one is converted to the variable's unit (URBI sheet, section 5). */
    static AssignmentTarget of(Action.Assign assignment, Variable variable, double value, Modifiers modifiers)
            throws Failure {
        if (!assignment.target().suffix().equals("'n")) {
            return new AssignmentTarget(value, modifiers);
        }
        Properties properties = variable.properties();
        double target = properties.denormalize(variable.name(), Math.max(0, Math.min(1, value)));
        return new AssignmentTarget(target, modifiers.scaled(properties.range()));
    }
}
