/**
 * Behaviours: programs with exclusive use of a robot, which a stop revokes at once. Sub-packages make, read and check
 * their files; docs/programmers-guide.md has the format.
 *
 * <p>Of MAJIC it imports only {@code majic.bot}, {@code majic.time} and {@code majic.team}; it depends neither on the
 * script language nor on the window.
 */
@NullMarked
package majic.act;

import org.jspecify.annotations.NullMarked;
