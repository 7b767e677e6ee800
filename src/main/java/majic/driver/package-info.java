/**
 * What the drivers of all robots share: the thread that reads a link. Knows no particular robot and no protocol.
 */
@NullMarked
package majic.driver;

import org.jspecify.annotations.NullMarked;
