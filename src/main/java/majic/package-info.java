/**
 * The program: command line, console, wiring. The only package that knows every other; nobody imports it.
 */
@NullMarked
package majic;

import org.jspecify.annotations.NullMarked;
