package majicsim.aibo;

import java.util.List;
import majicsim.aibo.body.BodyOrientation;
import majicsim.aibo.body.Sensors;
import majicsim.aibo.sound.Microphone;
import majicsim.aibo.sound.PlayedSound;
import majicsim.aibo.sound.Speaker;

/**
 * Physical access to the dog: its touch sensors, its posture in the room, its battery and sounds. Every call must hold
 * the lab's lock.
 */
public final class AiboHandling {
    private final Sensors sensors;
    private final BodyOrientation orientation;
    private final Speaker speaker;
    private final Microphone microphone;
    private final AiboBattery battery;

    AiboHandling(
            Sensors sensors, BodyOrientation orientation, Speaker speaker, Microphone microphone, AiboBattery battery) {
        this.sensors = sensors;
        this.orientation = orientation;
        this.speaker = speaker;
        this.microphone = microphone;
        this.battery = battery;
    }

    /**
     * Touches the dog, presses a paw or the switch, or releases it.
     *
     * @param sensor a touch sensor's URBI name, such as backSensorM, chinSensor, pawLF or WIFIswitch
     * @param value its reading from now on, in its own unit and clipped to its range; 0 is nothing
     * @throws IllegalArgumentException if there is no such touch sensor; nothing changes
     */
    public void touch(String sensor, double value) {
        sensors.touch(sensor, value);
    }

    /**
     * Turns the dog over about its long axis. When it is not on its feet, walking does not move it.
     *
     * @param degrees 0 on its feet, 90 on its right side, 180 on its back, any finite angle
     */
    public void roll(double degrees) {
        orientation.roll(degrees);
    }

    /**
     * The sounds that its speaker played, plays or has queued.
     *
     * @return the last 100 sounds, oldest first
     */
    public List<PlayedSound> played() {
        return speaker.played();
    }

    /**
     * Whistles beside the dog, for its microphones; a new whistle ends the one before.
     *
     * @param hertz pitch, above 0
     * @param ms how long from now on
     */
    public void whistle(double hertz, double ms) {
        microphone.whistle(hertz, ms);
    }

    /**
     * Replaces the battery while the dog runs. With an empty one nothing in the dog runs: it keeps its posture, sends
     * nothing, and closes each new connection. After the next replacement by one that is not empty it continues.
     *
     * @param charge 0 (empty) to 1 (full)
     */
    public void changeBattery(double charge) {
        battery.replace(charge);
    }
}
