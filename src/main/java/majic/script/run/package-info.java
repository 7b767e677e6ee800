/**
 * Checks and runs scripts: a command is an action that is checked, scheduled, recorded and run. Which actions there are
 * is known to {@code majic.script.actions} alone.
 */
@NullMarked
package majic.script.run;

import org.jspecify.annotations.NullMarked;
