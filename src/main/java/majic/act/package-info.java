/**
 * Behaviours: programs that have a robot to themselves for a while, and lose it the moment somebody says so. Also their
 * files: how they are made, read, checked and trusted; docs/programmers-guide.md has the form.
 *
 * <p>Of MAJIC this package imports {@code majic.bot} alone; it knows neither the script language nor a window.
 */
@NullMarked
package majic.act;

import org.jspecify.annotations.NullMarked;
