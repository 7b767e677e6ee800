/**
 * The motions of a vehicle: its stop, the mode that MAJIC drives in and loses to others, arming, motions by velocities,
 * and those by its own navigation.
 */
@NullMarked
package majic.mavlink.motion;

import org.jspecify.annotations.NullMarked;
