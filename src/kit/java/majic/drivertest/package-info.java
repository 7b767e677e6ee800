/**
 * The driver test kit: what the tests of a robot's driver need, for MAJIC's own drivers and for plug-ins. A test class
 * extends {@link majic.drivertest.DriverConformance}, and the robot is played by a
 * {@link majic.drivertest.ScriptedPeer} on a {@link majic.drivertest.TestClock}. Uses JUnit Jupiter and MAJIC's jar for
 * programs that embed robots, no window and no simulated lab.
 */
@NullMarked
package majic.drivertest;

import org.jspecify.annotations.NullMarked;
