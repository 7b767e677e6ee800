/** The program: command line, console, wiring. The only package that uses all others; no package uses it. */
@NullMarked
package majic;

import org.jspecify.annotations.NullMarked;
