/**
 * Finds the robots that a script names, and evaluates its conditions by reading them. Nothing here commands a robot.
 */
@NullMarked
package majic.script.conditions;

import org.jspecify.annotations.NullMarked;
