/**
 * Messages of ROS topics as typed values: made from the JSON that a rosbridge server sends, or turned into the JSON
 * that it takes. Units outside are those of MAJIC (mm, degrees, seconds); the metres and radians of ROS (REP-103) stay
 * inside. The package opens no connection and has no state. A number that a message gives as {@code null} (rosbridge's
 * form of NaN and infinity) is unknown here, never zero and never "nothing in range".
 */
@NullMarked
package majic.ros.message;

import org.jspecify.annotations.NullMarked;
