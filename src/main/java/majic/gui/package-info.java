/**
 * The window: {@link majic.gui.MajicFrame}, and one class for each panel and dialog in it.
 *
 * <p>Everything it does with robots goes through the team and the script session, so a console does the same. Nothing
 * here knows a particular make of robot, and nothing that may wait runs on the event dispatch thread.
 */
@NullMarked
package majic.gui;

import org.jspecify.annotations.NullMarked;
