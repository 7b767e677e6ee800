/**
 * The broker that the program can start itself: HiveMQ CE, whose libraries are not part of MAJIC, behind a class loader
 * of its own, because they conflict with those of MAJIC.
 */
@NullMarked
package majic.shared.embedded;

import org.jspecify.annotations.NullMarked;
