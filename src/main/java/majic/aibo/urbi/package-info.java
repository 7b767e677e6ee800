/** The URBI client: from bytes to messages and from commands to bytes, over the three connections to one dog. */
@NullMarked
package majic.aibo.urbi;

import org.jspecify.annotations.NullMarked;
