/** Dialogs for behaviours: choosing, consent, roles, making. */
@NullMarked
package majic.gui.acts;

import org.jspecify.annotations.NullMarked;
