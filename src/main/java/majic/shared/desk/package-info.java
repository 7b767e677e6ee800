/**
 * A desk that shares its robots: publishes what they are and do, lets one program at a time command each of them from
 * another desk, and stops them when that program, the broker or a robot's own connection is gone. Also the STOP of all
 * desks of a site.
 */
@NullMarked
package majic.shared.desk;

import org.jspecify.annotations.NullMarked;
