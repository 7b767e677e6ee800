package majicsim.mavlink;

/**
 * What can be done beside a vehicle: its radio pilot, its switch and its battery; and what it counts, for tests. Every
 * call must hold the lab's lock.
 */
public final class MavlinkHandling {
    private final Vehicle vehicle;
    private final Runnable restart;

    MavlinkHandling(Vehicle vehicle, Runnable restart) {
        this.vehicle = vehicle;
        this.restart = restart;
    }

    /**
     * The pilot changes the mode by a switch of the radio.
     *
     * @param mode its number, as in HEARTBEAT
     * @return false if the vehicle refuses
     */
    public boolean pilotMode(int mode) {
        return vehicle.change(mode) == CommandResult.ACCEPTED;
    }

    /**
     * The pilot moves a stick of the radio, which a ground station's override hides as long as it lasts.
     *
     * @param channel 1 to 18; of a rover 1 steers and 3 is the throttle; of a copter 1 rolls, 2 pitches, 3 climbs and 4
     *     turns
     * @param micros 1000 to 2000
     */
    public void pilotStick(int channel, int micros) {
        vehicle.board().radio().move(channel, micros);
    }

    /** Switches the vehicle off and on: it starts anew, disarmed, and its links forget the rates asked for. */
    public void restart() {
        restart.run();
    }

    /**
     * Makes the vehicle send a text to all ground stations; a long one comes in pieces.
     *
     * @param severity 0 emergency to 7 debug
     * @param text Latin-1
     */
    public void say(int severity, String text) {
        vehicle.say(severity, text);
    }

    /**
     * Charges or discharges the battery.
     *
     * @param percent 0 to 100
     */
    public void charge(double percent) {
        vehicle.board().battery().charge(percent);
    }

    /**
     * Its mode.
     *
     * @return the number as in HEARTBEAT
     */
    public int mode() {
        return vehicle.mode();
    }

    /**
     * Whether its motors are armed.
     *
     * @return true if they are
     */
    public boolean isArmed() {
        return vehicle.isArmed();
    }

    /**
     * How high it is.
     *
     * @return m above the floor; 0 of a rover
     */
    public double heightM() {
        return vehicle.motion().height();
    }

    /**
     * How often a copter hit the ground faster than 2 m/s.
     *
     * @return since the lab was opened; 0 of a rover
     */
    public int crashes() {
        return vehicle instanceof Copter copter ? copter.flight().crashes() : 0;
    }

    /**
     * How often a copter was disarmed in the air, which only force does.
     *
     * @return since the lab was opened; 0 of a rover
     */
    public int disarmsInFlight() {
        return vehicle instanceof Copter copter ? copter.disarmsInFlight() : 0;
    }
}
