/**
 * Running commands: a task for each, the context in which it runs, and how it sees the server and its connection.
 */
@NullMarked
package majicsim.aibo.urbi.run;

import org.jspecify.annotations.NullMarked;
