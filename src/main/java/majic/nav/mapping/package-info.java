/**
 * Mapping: scan matching, loop closure and a graph of poses make a map from the scans and the odometry of a robot. The
 * sparse algebra is that of EJML, which is loaded with the first loop.
 */
@NullMarked
package majic.nav.mapping;

import org.jspecify.annotations.NullMarked;
