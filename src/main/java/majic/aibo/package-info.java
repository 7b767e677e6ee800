/**
 * The Sony Aibo ERS-7 with an URBI memory stick: its URBI client from bytes to commands, and the robot on top of it.
 * Only the robot, its type and its panel are public. Imports nothing of MAJIC's but {@code bot} and {@code link}; Swing
 * stays in the panel.
 */
@NullMarked
package majic.aibo;

import org.jspecify.annotations.NullMarked;
