/**
 * The driver of the MobileRobots Pioneer. Its packages turn bytes into packets ({@code arcos}) and packets into states
 * ({@code state}), keep a connection ({@code session}), describe parameters and commands ({@code parameters}) and show
 * the robot ({@code panel}).
 */
@NullMarked
package majic.pioneer;

import org.jspecify.annotations.NullMarked;
