/** The panel of a shared robot: it shows what its desk reports, whatever the type of the robot. */
@NullMarked
package majic.shared.panel;

import org.jspecify.annotations.NullMarked;
