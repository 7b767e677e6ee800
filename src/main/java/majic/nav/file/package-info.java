/**
 * Files of maps and of scans: map_server (ROS), the Pioneer world's maps, CARMEN logs. A file that cannot be used is
 * refused with one sentence that has the line and what would be right.
 */
@NullMarked
package majic.nav.file;

import org.jspecify.annotations.NullMarked;
