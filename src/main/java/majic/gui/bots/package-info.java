/**
 * The robots' tabs.
 */
@NullMarked
package majic.gui.bots;

import org.jspecify.annotations.NullMarked;
