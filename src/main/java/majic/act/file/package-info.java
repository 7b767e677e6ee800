/**
 * Files of behaviours: reading, checking, finding and trusting them, with no code of theirs run before consent.
 */
@NullMarked
package majic.act.file;

import org.jspecify.annotations.NullMarked;
