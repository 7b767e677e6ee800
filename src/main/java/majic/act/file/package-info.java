/**
 * Reads, checks and finds files of behaviours and stores the user's consent to them, without running their code before
 * that.
 */
@NullMarked
package majic.act.file;

import org.jspecify.annotations.NullMarked;
