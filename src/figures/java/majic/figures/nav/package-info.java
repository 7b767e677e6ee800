/** Measures maps, localisation and going to places, with a public log and in an office of the lab. */
@NullMarked
package majic.figures.nav;

import org.jspecify.annotations.NullMarked;
