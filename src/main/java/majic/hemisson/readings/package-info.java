/**
 * What a Hemisson answers to the questions that it is asked again and again, and what that means: infra-red proximity,
 * light, switches.
 */
@NullMarked
package majic.hemisson.readings;

import org.jspecify.annotations.NullMarked;
