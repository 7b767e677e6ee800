/** Scripts as behaviours: which robots they mean and what these must have. */
@NullMarked
package majic.script.acts;

import org.jspecify.annotations.NullMarked;
