package majicsim.pioneer;

import java.util.List;
import java.util.function.UnaryOperator;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.devices.Tone;

/**
 * Physical access to the robot: its buttons, plugs, inputs and outputs. Works with or without a client connected; what
 * a model does not carry (gripper, charger) shows no effect. Every call must hold the lab's lock.
 */
public final class PioneerHandling {
    private final Devices devices;
    private final Runnable reset;

    PioneerHandling(Devices devices, Runnable reset) {
        this.devices = devices;
        this.reset = reset;
    }

    /**
     * Presses the red STOP button, or releases it.
     *
     * @param down true while it is pressed
     */
    public void pressStop(boolean down) {
        devices.stopButton().press(down);
    }

    /**
     * Presses the reset button: the controller restarts, receives nothing for a second, and sends packet 0xFE to its
     * client.
     */
    public void pressReset() {
        reset.run();
    }

    /**
     * Switches the power of the charger on or off.
     *
     * @param on true while there is power
     */
    public void plugCharger(boolean on) {
        devices.charger().power(on);
    }

    /**
     * Heats or cools the controller.
     *
     * @param celsius its temperature from now on; 65 and more raises the warning
     */
    public void heat(int celsius) {
        devices.thermometer().set(celsius);
    }

    /**
     * Pushes the joystick. It drives the robot while the fire button is held.
     *
     * @param right -1 (left) to 1 (right)
     * @param ahead -1 (back) to 1 (ahead)
     */
    public void pushJoystick(double right, double ahead) {
        devices.joystick().push(right, ahead);
    }

    /**
     * Presses the joystick's buttons, or releases them.
     *
     * @param fire the one that makes the robot drive
     * @param second the other
     */
    public void pressJoystick(boolean fire, boolean second) {
        devices.joystick().buttons(fire, second);
    }

    /**
     * Turns the joystick's throttle.
     *
     * @param share 0 (no speed) to 1 (full speed)
     */
    public void throttle(double share) {
        devices.joystick().throttle(share);
    }

    /**
     * Closes a contact at a digital input, or opens it; closed reads as a bit that is 0.
     *
     * @param bit 0 to 7
     * @param closed true for closed
     * @throws IndexOutOfBoundsException if there is no such bit; nothing changed
     */
    public void digitalInput(int bit, boolean closed) {
        devices.userPort().input(bit, closed);
    }

    /**
     * Puts a voltage on an analog input.
     *
     * @param port 0 to 7
     * @param volts 0 to 5
     * @throws IndexOutOfBoundsException if there is no such port; nothing changed
     */
    public void analogInput(int port, double volts) {
        devices.userPort().analog(port, volts);
    }

    /**
     * Puts an object before an infra-red sensor, or takes it away.
     *
     * @param eye 0 to 7
     * @param near true while something is near
     * @throws IndexOutOfBoundsException if there is no such eye; nothing changed
     */
    public void infrared(int eye, boolean near) {
        devices.infrared().see(eye, near);
    }

    /**
     * Sets whether the two ledge sensors, which face the floor ahead, detect a ledge.
     *
     * @param far some way off
     * @param near close by
     */
    public void ledge(boolean far, boolean near) {
        devices.infrared().ledge(far, near);
    }

    /**
     * Puts an object between the gripper's paddles, or takes it away.
     *
     * @param object true while it is there
     */
    public void putBetweenPaddles(boolean object) {
        devices.gripper().put(object);
    }

    /**
     * Plugs a device into one of the serial ports for accessories, in place of the loopback plug.
     *
     * @param port 1 to 3
     * @param device receives the bytes sent to it and returns its answer, no bytes if it has none
     * @throws IndexOutOfBoundsException if there is no such port; nothing changed
     */
    public void plugAux(int port, UnaryOperator<byte[]> device) {
        devices.auxPorts().get(port - 1).plug(device);
    }

    /**
     * The tones that the buzzer played, with rests and warning beeps, except while it was muted.
     *
     * @return the last 200 tones that began, oldest first
     */
    public List<Tone> played() {
        return devices.buzzer().heard();
    }

    /**
     * The tone that sounds now.
     *
     * @return hertz, 0 for silence
     */
    public double soundingHertz() {
        return devices.buzzer().soundingHertz();
    }
}
