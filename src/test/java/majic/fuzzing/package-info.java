/**
 * A program that searches for input that makes a fuzz test fail, with coverage guidance, one test after the other. See
 * CONTRIBUTING.
 */
@NullMarked
package majic.fuzzing;

import org.jspecify.annotations.NullMarked;
