/**
 * Shared robots as vehicles of VDA 5050, version 2.0.0, beside the topics of MAJIC, for fleet tools that watch and stop
 * them. {@link majic.shared.vda5050.FleetVehicle} states what does not fit.
 */
@NullMarked
package majic.shared.vda5050;

import org.jspecify.annotations.NullMarked;
