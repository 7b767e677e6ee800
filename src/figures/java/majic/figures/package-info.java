/**
 * A program that measures MAJIC: time to the visible window, processor time of an idle window, delays of the event
 * dispatch thread, actions of the command line, memory over a long run. See CONTRIBUTING.
 */
@NullMarked
package majic.figures;

import org.jspecify.annotations.NullMarked;
