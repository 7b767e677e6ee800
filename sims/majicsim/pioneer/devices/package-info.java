/** The devices around the controller: power, gripper, gyro, joystick, buttons, serial and user ports. */
@NullMarked
package majicsim.pioneer.devices;

import org.jspecify.annotations.NullMarked;
