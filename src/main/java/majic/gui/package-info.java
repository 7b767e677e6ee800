/**
 * The window: {@link majic.gui.MajicFrame}, and one class for each panel and dialog in it.
 *
 * <p>All commands to robots go through the team and the script session, as in the console. No class here depends on a
 * particular make of robot, and nothing that may block runs on the event dispatch thread.
 */
@NullMarked
package majic.gui;

import org.jspecify.annotations.NullMarked;
