/** The team strip with a card for each robot, and the panels of the selected robots. */
@NullMarked
package majic.gui.bots;

import org.jspecify.annotations.NullMarked;
