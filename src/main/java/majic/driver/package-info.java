/**
 * What the drivers of all robots share: {@link majic.driver.BotDriver}, which each driver extends, the motions and the
 * tables of parameters and commands that it works with, the permits by which teams and acts let one user command a
 * robot, the reader thread of a link, assumed settings, calibration. Independent of robots and protocols.
 */
@NullMarked
package majic.driver;

import org.jspecify.annotations.NullMarked;
