/** What each command does when it runs, and the table from command to task. */
@NullMarked
package majicsim.aibo.urbi.command;

import org.jspecify.annotations.NullMarked;
