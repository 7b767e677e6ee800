/**
 * The reports of a Pioneer in usual units: model and equipment, odometry, sonar readings, power, limits. Has no link
 * and no thread.
 */
@NullMarked
package majic.pioneer.state;

import org.jspecify.annotations.NullMarked;
