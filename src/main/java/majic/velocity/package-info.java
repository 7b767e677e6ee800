/**
 * Motions of a robot that obeys velocities and reports where it is, the base: velocities with limited acceleration,
 * repeated as long as the base moves; motions closed by odometry; stops, repeated until the odometry shows the base
 * stationary. Uses no connection and no message, only {@link majic.velocity.VelocityOutput} and the readings passed to
 * {@link majic.velocity.VelocityMotion}.
 */
@NullMarked
package majic.velocity;

import org.jspecify.annotations.NullMarked;
