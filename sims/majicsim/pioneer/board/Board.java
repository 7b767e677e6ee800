package majicsim.pioneer.board;

import majicsim.pioneer.devices.Bumpers;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.motion.Drive;
import majicsim.pioneer.motion.MotionLimits;
import majicsim.pioneer.ranging.Laser;
import majicsim.pioneer.ranging.SonarCone;
import majicsim.pioneer.ranging.SonarFiring;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;

/** The robot itself, without any client: motors, sonar and devices, and how they depend on each other. */
public final class Board {
    private static final System.Logger LOG = System.getLogger(Board.class.getName());

    private final PioneerModel model;
    private final String name;
    private final World world;
    private final Body body;
    private final Pose start;
    private final Boot boot = new Boot();
    private final Drive drive;
    private final SonarFiring sonar;
    private final Laser laser;
    private final Bumpers bumpers;
    private final Devices devices;
    private final JoyDrive joyDrive;
    private boolean hasClient;
    private long stepNanos;
    private boolean lifted;

    public Board(World world, Body body, PioneerModel model, String name, Noise noise) {
        this.model = model;
        this.name = name;
        this.world = world;
        this.body = body;
        this.start = body.pose();
        this.drive = new Drive(body, model, noise.fork("wheels"));
        this.laser = new Laser(world, body, model, noise.fork("laser"));
        this.sonar = new SonarFiring(model, new SonarCone(world, body, noise.fork("sonar")));
        this.bumpers = new Bumpers(model, body);
        this.devices = new Devices(model.equipment(), noise);
        this.joyDrive = new JoyDrive(devices.joystick(), devices.settings(), drive);
    }

    public Drive drive() {
        return drive;
    }

    public SonarFiring sonar() {
        return sonar;
    }

    public Bumpers bumpers() {
        return bumpers;
    }

    public Devices devices() {
        return devices;
    }

    public Laser laser() {
        return laser;
    }

    public PioneerModel model() {
        return model;
    }

    public String name() {
        return name;
    }

    public Pose truePose() {
        return body.pose();
    }

    public int clockMicros() {
        return boot.clockMicros();
    }

    /** Whether the controller receives anything: not while it restarts, nor in maintenance mode. */
    public boolean isListening() {
        return boot.isListening();
    }

    /**
     * Reports the end of a handshake: motors off, odometry 0, stored parameters; sonar waits for OPEN (ARCOS sheet 5.1,
     * 5.2).
     */
    public void beginSession() {
        endSession();
        hasClient = true;
        drive.setOdometry(new Pose(0, 0, 0));
    }

    /** Brakes with motors off; battery and pose do not change. */
    public void endSession() {
        MotionLimits stored = MotionLimits.stored(model);
        hasClient = false;
        drive.enable(false);
        drive.hold(false);
        drive.limitTranslation(old -> stored.translation());
        drive.limitRotation(old -> stored.rotation());
        sonar.stop();
        devices.restore();
    }

    /** RESET, or the button for it: restores the state after power-up; receives nothing for a short time. */
    public void restart() {
        endSession();
        drive.setOdometry(new Pose(0, 0, 0));
        devices.reset();
        boot.restart();
    }

    /** MAINTENANCE: receives nothing until the next restart. */
    public void maintain() {
        endSession();
        boot.maintain();
    }

    /** ENABLE: motors on or off; while the STOP button is pressed they stay off. */
    public void enable(boolean on) {
        drive.enable(on && !devices.stopButton().holdsMotors());
    }

    /** MOVE, if the controller has it. */
    public void move(int mm) {
        if (model.hasMove()) {
            drive.move(mm);
        }
    }

    /** VEL2 in the model's units. */
    public void wheels(int left, int right) {
        double unit = model.scaling().vel2UnitMmPerSec();
        drive.wheels(left * unit, right * unit);
    }

    public void step(double seconds) {
        stepNanos = Math.round(seconds * 1e9);
        drive.step(seconds);
        joyDrive.step(hasClient);
        applyStopButton();
        applyBumpers();
        pass(stepNanos);
    }

    /** How long nothing is due on a robot that is stationary and left alone; 0 if it moves, ns. */
    public long restNanos() {
        return drive.isAtRest() && devices.isAtRest() && boot.isListening() ? sonar.restNanos() : 0;
    }

    /** Lets time pass on the stationary robot, less than {@link #restNanos}. */
    public void rest(long nanos) {
        pass(nanos);
    }

    private void pass(long nanos) {
        boot.step(nanos);
        sonar.step(nanos);
        devices.step(nanos, effort(), body.turnDegPerSec());
    }

    /** Whether the SIP must show a stall; records that it was reported. */
    public boolean reportStall() {
        boolean stalled = drive.stall().report();
        return stalled || devices.stopButton().holdsMotors();
    }

    /** SIM_SET_POSE: puts the robot elsewhere in the room, if it fits there. Odometry does not change. */
    public void place(Pose pose) {
        if (!world.room().bounds().contains(pose.xMm(), pose.yMm())) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer stays where it is: {0} is outside the room", pose);
            return;
        }
        try {
            body.place(pose);
            lifted = true;
        } catch (IllegalArgumentException e) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer stays where it is: {0}", e.getMessage());
        }
    }

    /** Whether a client has put it elsewhere in the room since the last call. */
    public boolean wasLifted() {
        boolean was = lifted;
        lifted = false;
        return was;
    }

    /** SIM_RESET: back to the start, odometry 0. */
    public void backToStart() {
        drive.halt();
        place(start);
        drive.setOdometry(new Pose(0, 0, 0));
    }

    /** The length of the last step, ms. */
    public int stepMs() {
        return (int) (stepNanos / 1_000_000);
    }

    private void applyStopButton() {
        if (drive.isEnabled() && devices.stopButton().holdsMotors()) {
            drive.emergencyStop();
            drive.enable(false);
        }
    }

    private void applyBumpers() {
        if (body.contact().touching()
                && bumpers.stall(devices.settings().get(Setting.BUMPSTALL), drive.plannedMmPerSec())) {
            drive.bumped();
        }
    }

    /** How much of its top speed it drives, 0 to 1. */
    private double effort() {
        return Math.min(1, Math.abs(drive.speedMmPerSec()) / model.topSpeedMmPerSec());
    }
}
