/** Running commands: a task for each, its context, and the interfaces of server and connection that it uses. */
@NullMarked
package majicsim.aibo.urbi.run;

import org.jspecify.annotations.NullMarked;
