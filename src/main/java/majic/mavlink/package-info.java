/**
 * The driver of vehicles that speak MAVLink: rovers and boats with ArduPilot are driven, aircraft and submarines are
 * shown, stopped and taken down or home.
 */
@NullMarked
package majic.mavlink;

import org.jspecify.annotations.NullMarked;
