/**
 * The bus and the modules that can be plugged onto the robot: registers, camera, ultrasonic, voice, display, inputs and
 * outputs.
 */
@NullMarked
package majicsim.hemisson.modules;

import org.jspecify.annotations.NullMarked;
