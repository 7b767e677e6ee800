/**
 * Robot makers' Java libraries, which are not part of this program: finds the installed ones and loads them, together
 * with the adapter classes that use them, in class loaders of their own.
 */
@NullMarked
package majic.vendor;

import org.jspecify.annotations.NullMarked;
