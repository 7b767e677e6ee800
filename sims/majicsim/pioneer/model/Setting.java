package majicsim.pioneer.model;

/**
 * A number that the controller stores: CONFIG shows it, and a command may change its working value until the session
 * ends (ARCOS sheet 5.1, 6.1, 10). The stored values are the sheet's where it has one, else typical of the manuals.
 */
public enum Setting {
    AUX1_BAUD(0),
    AUX2_BAUD(0),
    AUX3_BAUD(0),
    /** 0.1 V; below it the buzzer warns. */
    LOW_BATTERY(115),
    REVCOUNT(16570),
    /** PWM limit. */
    STALLVAL(200),
    /** Milliseconds without motor power after a stall. */
    STALLCOUNT(200),
    /** mm/s at full push of the joystick. */
    JOYVEL(600),
    /** deg/s at full push of the joystick. */
    JOYRVEL(60),
    ROTKP(40),
    ROTKV(20),
    ROTKI(0),
    TRANSKP(40),
    TRANSKV(30),
    TRANSKI(0),
    DRIFTFACTOR(0),
    /** The resolution that the controller assumes for the encoders; that of the real ones is another. */
    TICKSMM(128),
    /** 0.1 V; 0 as this robot never switches itself off. */
    SHUTDOWN(0),
    GYRO_CLOCKWISE(0),
    GYRO_COUNTERCLOCKWISE(0),
    /** 0 none, 1 front, 2 rear, 3 both: which bumpers stall the robot. */
    BUMPSTALL(3),
    /** 1 if the STOP button stalls and disables the motors. */
    E_STALL(1),
    /** 1 if the joystick may drive while a client is connected. */
    JOYDRIVE(0),
    MOVINGBLINK(0),
    CALCOMP(0);

    private final int stored;

    Setting(int stored) {
        this.stored = stored;
    }

    public int stored() {
        return stored;
    }
}
