/** Robots by number: their queues, their owners, manual control, and the STOP for all of them. */
@NullMarked
package majic.team;

import org.jspecify.annotations.NullMarked;
