/**
 * The act maker: from classes, a source or a jar to a file of a behaviour.
 */
@NullMarked
package majic.act.make;

import org.jspecify.annotations.NullMarked;
