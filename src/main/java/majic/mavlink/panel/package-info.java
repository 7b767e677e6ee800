/**
 * The panel that shows one MAVLink vehicle: a map, the newest texts of its autopilot, an artificial horizon with a
 * compass, readings, lights, and buttons for its mode and its own commands. It gets what it shows as one record, beside
 * the parameters, and submits commands as if they had been typed.
 */
@NullMarked
package majic.mavlink.panel;

import org.jspecify.annotations.NullMarked;
