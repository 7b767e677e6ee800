/**
 * One connection to one vehicle: finds it, asks for its reports, keeps the newest ones, sends commands and awaits their
 * answers, reads and sets the parameters of its autopilot.
 */
@NullMarked
package majic.mavlink.session;

import org.jspecify.annotations.NullMarked;
