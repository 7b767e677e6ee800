/**
 * What the panels of robots share: colours, readings in columns, the way news come onto the screen. Used by the panel
 * classes of robots' packages, also of those that come as plug-ins, and by the window; a driver must load without it. Nothing here
 * knows a particular robot, and nothing here sends a robot anything.
 */
@NullMarked
package majic.panel;

import org.jspecify.annotations.NullMarked;
