/**
 * Components that the panels of robots share: colours, readings in columns, refreshing after events. Used by the panel
 * classes of robots' packages, also of those in plug-ins, and by the window; a driver must load without it. Nothing
 * here depends on a particular robot, and nothing here sends anything to a robot.
 */
@NullMarked
package majic.panel;

import org.jspecify.annotations.NullMarked;
