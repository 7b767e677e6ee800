/**
 * The URBI connections of a dog by liburbi-java, a library that is not part of this program. These classes are loaded
 * together with the installed library, so nothing else may use them by name.
 */
@NullMarked
package majic.aibo.liburbi;

import org.jspecify.annotations.NullMarked;
