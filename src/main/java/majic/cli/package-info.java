/** The command line of the program: commands and options. */
@NullMarked
package majic.cli;

import org.jspecify.annotations.NullMarked;
