/** The controller board without any client: motors, sonar and devices, and how they depend on each other. */
@NullMarked
package majicsim.pioneer.board;

import org.jspecify.annotations.NullMarked;
