/**
 * What the drivers of all robots share: the reader thread of a link, parameter themes, assumed settings. Independent of
 * robots and protocols.
 */
@NullMarked
package majic.driver;

import org.jspecify.annotations.NullMarked;
