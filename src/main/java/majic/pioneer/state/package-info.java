/**
 * What a Pioneer reports, turned into meaning: model and equipment, odometry, sonar readings, power, limits. No link,
 * no thread.
 */
@NullMarked
package majic.pioneer.state;

import org.jspecify.annotations.NullMarked;
