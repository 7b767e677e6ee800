/**
 * The connection to a Pioneer through ARIA, the library of the robot's maker. These classes are loaded together with
 * the installed library, in a class loader of its own, and only when an address names it.
 */
@NullMarked
package majic.pioneer.aria;

import org.jspecify.annotations.NullMarked;
