/**
 * Robots by number: their queues, their owners, manual control, and the STOP that reaches them all.
 */
@NullMarked
package majic.team;

import org.jspecify.annotations.NullMarked;
