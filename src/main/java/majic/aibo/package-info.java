/**
 * The Sony Aibo ERS-7 with an URBI memory stick: the robot, its type, and how the packages below are put together.
 * {@code urbi} is the client, {@code body} the parts and readings of the dog, {@code session} one connection.
 */
@NullMarked
package majic.aibo;

import org.jspecify.annotations.NullMarked;
