/**
 * The conversation with a Hemisson over one line: bytes to lines, questions and their answers one at a time, stops and
 * their confirmation, connecting and closing.
 */
@NullMarked
package majic.hemisson.line;

import org.jspecify.annotations.NullMarked;
