/** What distinguishes one Pioneer model from another: equipment, scaling, sonar layout and the stored settings. */
@NullMarked
package majicsim.pioneer.model;

import org.jspecify.annotations.NullMarked;
