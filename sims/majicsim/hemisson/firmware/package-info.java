/** The firmware: the commands of both makers and those for modules. */
@NullMarked
package majicsim.hemisson.firmware;

import org.jspecify.annotations.NullMarked;
