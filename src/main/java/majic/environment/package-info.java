/**
 * What a program provides to the drivers of its robots: the clock, and the settings that are kept from one start of the
 * program to the next.
 */
@NullMarked
package majic.environment;

import org.jspecify.annotations.NullMarked;
