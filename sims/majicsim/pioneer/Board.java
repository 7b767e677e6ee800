package majicsim.pioneer;

import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;

/** The robot itself, without any client: motors, sonar, battery, outputs, and the packets that tell of them. */
final class Board {
    private static final System.Logger LOG = System.getLogger(Board.class.getName());
    private static final int FULL_BATTERY_TENTH_VOLTS = 130;
    /** About what a P3-DX counts (ARCOS sheet 11.1). */
    private static final int TICKS_PER_MM = 128;

    private static final int ALL_OUTPUTS = 0xFF;
    /** How the battery's voltage shows among the analog values: our own scale, 25.6 V full. */
    private static final int ANALOG_PER_TENTH_VOLT = 4;

    private final PioneerModel model;
    private final String name;
    private final World world;
    private final Body body;
    private final Pose start;
    private final Drive drive;
    private final SonarFiring sonar;
    private int batteryTenthVolts = FULL_BATTERY_TENTH_VOLTS;
    private int digitalOut = ALL_OUTPUTS;
    private int analogPort;
    private long stepNanos;

    Board(World world, Body body, PioneerModel model, String name, Noise noise) {
        this.model = model;
        this.name = name;
        this.world = world;
        this.body = body;
        this.start = body.pose();
        this.drive = new Drive(body, model, noise.fork("wheels"));
        this.sonar = new SonarFiring(model, new SonarCone(world, body, noise.fork("sonar")));
    }

    Drive drive() {
        return drive;
    }

    SonarFiring sonar() {
        return sonar;
    }

    PioneerModel model() {
        return model;
    }

    String name() {
        return name;
    }

    /** A client has shaken hands: motors off, odometry 0, stored parameters; sonar waits for OPEN (ARCOS sheet 5.1, 5.2). */
    void beginSession() {
        endSession();
        drive.setOdometry(new Pose(0, 0, 0));
    }

    /** Brakes with motors off; battery and place stay as they are. */
    void endSession() {
        MotionLimits stored = MotionLimits.stored(model);
        drive.enable(false);
        drive.hold(false);
        drive.limitTranslation(old -> stored.translation());
        drive.limitRotation(old -> stored.rotation());
        sonar.stop();
    }

    void step(double seconds) {
        stepNanos = Math.round(seconds * 1e9);
        drive.step(seconds);
        sonar.step(stepNanos);
    }

    /** BATTEST: pretends this voltage in 0.1 V; 0 is the real one again. */
    void pretendBattery(int tenthVolts) {
        batteryTenthVolts = tenthVolts > 0 ? tenthVolts : FULL_BATTERY_TENTH_VOLTS;
    }

    /** DIGOUT: changes the outputs that the mask chooses. */
    void digitalOut(int states, int mask) {
        digitalOut = (digitalOut & ~mask | states & mask) & ALL_OUTPUTS;
    }

    /** ADSEL: the analog port that the SIP shows. */
    void analogPort(int port) {
        analogPort = port;
    }

    /** SIM_SET_POSE: puts the robot elsewhere in the room; where it does not fit it stays. Odometry does not notice. */
    void place(Pose pose) {
        if (!world.room().bounds().contains(pose.xMm(), pose.yMm())) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer stays where it is: {0} is outside the room", pose);
            return;
        }
        try {
            body.place(pose);
        } catch (IllegalArgumentException e) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer stays where it is: {0}", e.getMessage());
        }
    }

    /** SIM_RESET: back to the start, odometry 0. */
    void backToStart() {
        drive.halt();
        place(start);
        drive.setOdometry(new Pose(0, 0, 0));
    }

    /** The state now; takes the sonar readings along, which are new only once. */
    Sip sip() {
        return new Sip(motion(), status(), sonar.takeFresh());
    }

    byte[] config() {
        return new ConfigReport(
                        name,
                        model,
                        MotionLimits.tops(model),
                        drive.limits(),
                        Math.min(255, sonar.cycleMs()),
                        TICKS_PER_MM)
                .toBytes();
    }

    byte[] simStat() {
        Pose believed = drive.odometry();
        Pose right = drive.odometryWithoutError();
        Pose error = new Pose(
                believed.xMm() - right.xMm(), believed.yMm() - right.yMm(), believed.headingDeg() - right.headingDeg());
        return new SimStat((int) (stepNanos / 1_000_000), body.pose(), error).toBytes();
    }

    /** ARCOS sheet 11.1. */
    byte[] encoders() {
        double middle = drive.countedMm();
        double aside = model.scaling().wheelMmPerSec(drive.countedDeg());
        return new PacketWriter(0x90)
                .int32((int) Math.round((middle - aside) * TICKS_PER_MM))
                .int32((int) Math.round((middle + aside) * TICKS_PER_MM))
                .toBytes();
    }

    /** ARCOS sheet 11.2: digital inputs, bumpers front and rear, infra-red (all active low); outputs; analog, battery last. */
    byte[] inputsAndOutputs() {
        return new PacketWriter(0xF0)
                .uint8(4)
                .uint8(Sip.DIGITAL_INPUTS_IDLE)
                .uint8(~(Bumpers.front(model, body.contact()) >> 1))
                .uint8(~(Bumpers.rear(model, body.contact()) >> 1))
                .uint8(Sip.DIGITAL_INPUTS_IDLE)
                .uint8(1)
                .uint8(digitalOut)
                .uint8(2)
                .uint16(0)
                .uint16(Math.min(1023, batteryTenthVolts * ANALOG_PER_TENTH_VOLT))
                .toBytes();
    }

    /** ARCOS sheet 11.3: it has no batteries that report themselves. */
    byte[] batteries() {
        return new PacketWriter(0xFA).uint8(0).uint8(5).toBytes();
    }

    private SipMotion motion() {
        Scaling scaling = model.scaling();
        Pose at = drive.odometry();
        double aside = scaling.wheelMmPerSec(drive.turnDegPerSec());
        return new SipMotion(
                scaling.position(at.xMm()),
                scaling.position(at.yMm()),
                scaling.heading(at.headingDeg()),
                scaling.speed(drive.speedMmPerSec() - aside),
                scaling.speed(drive.speedMmPerSec() + aside),
                scaling.heading(drive.headingSetPointDeg()),
                (int) Math.round(drive.turnDegPerSec() * 10));
    }

    private SipStatus status() {
        int stall = drive.stall().report() ? 1 : 0;
        int flags = (drive.isEnabled() ? 1 : 0) | sonar.arraysOn() << 1;
        return new SipStatus(
                batteryTenthVolts,
                stall | Bumpers.rear(model, body.contact()),
                stall | Bumpers.front(model, body.contact()),
                flags,
                analogPort,
                digitalOut);
    }
}
