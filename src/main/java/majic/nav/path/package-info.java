/** Ways across a map: how much room there is, and the shortest way. */
@NullMarked
package majic.nav.path;

import org.jspecify.annotations.NullMarked;
