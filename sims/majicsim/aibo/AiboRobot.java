package majicsim.aibo;

import majicsim.aibo.body.BodyOrientation;
import majicsim.aibo.body.Gait;
import majicsim.aibo.body.GaitTask;
import majicsim.aibo.body.Head;
import majicsim.aibo.body.Joint;
import majicsim.aibo.body.Sensors;
import majicsim.aibo.camera.Camera;
import majicsim.aibo.camera.CameraLens;
import majicsim.aibo.sound.Microphone;
import majicsim.aibo.sound.Speaker;
import majicsim.aibo.urbi.Kernel;
import majicsim.aibo.urbi.MemoryStick;
import majicsim.aibo.urbi.run.Functions;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.value.Value;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;

/**
 * A simulated Aibo ERS-7 with an URBI 1.0 server, for any number of clients. Its motors are loose until {@code motors
 * on}. It runs on lab time: the kernel's cycle is 32 ms, and a command that need not wait runs as soon as it arrives.
 * Guarded by the lab's lock.
 */
public final class AiboRobot implements Firmware {
    private static final double FRONT_MM = 150;
    private static final double REAR_MM = 120;
    private static final double HALF_WIDTH_MM = 70;
    private static final double ROUNDING_MS = 1e-6;

    private final Kernel kernel;
    private final AiboBattery battery = new AiboBattery();
    private final Body body;
    private final AiboDevices devices;
    private final Sensors sensors;
    private final Gait gait;
    private final BodyOrientation orientation;
    private final AiboHandling handling;
    private final Camera camera;
    private final Speaker speaker;
    private final Microphone microphone;
    private double stepMs = 4;
    private double nextCycleMs = Server.CYCLE_MS;

    /**
     * Puts a dog into a room.
     *
     * @param world the room; its body is added
     * @param start its start pose, lying
     * @param noise exact for a dog with exactly the values of the sheet's tables
     */
    public AiboRobot(World world, Pose start, Noise noise) {
        Noise own = noise.fork("aibo");
        body = Body.box("aibo", FRONT_MM, REAR_MM, HALF_WIDTH_MM, start);
        world.add(body);
        kernel = new Kernel(own.fork("random"));
        devices = new AiboDevices(kernel.memory().variables(), kernel.memory().groups());
        orientation = new BodyOrientation(devices.legs());
        gait = new Gait(body, devices.legs(), orientation, own.fork("gait"));
        Head head = new Head(world, body, devices.joints(), orientation);
        sensors = new Sensors(world, body, head, orientation, gait, own.fork("sensors"));
        speaker = new Speaker(kernel);
        microphone = new Microphone(kernel, speaker, gait, own.fork("microphone"));
        handling = new AiboHandling(sensors, orientation, speaker, microphone, battery);
        camera = new Camera(new CameraLens(world, body, head, own.fork("camera")), kernel);
        install();
    }

    /**
     * Its body in the room.
     *
     * @return the body that the gait moves
     */
    public Body body() {
        return body;
    }

    /**
     * Physical access to it.
     *
     * @return the same object at every call; for use with the lab's lock held
     */
    public AiboHandling handling() {
        return handling;
    }

    @Override
    public void connected(Line line) {
        if (battery.isEmpty()) {
            line.close();
            return;
        }
        kernel.connect(line);
    }

    @Override
    public void received(Line line, byte[] bytes) {
        if (battery.isEmpty()) {
            return;
        }
        kernel.received(line, bytes);
        gait.drive(kernel.nowMs(), stepMs);
    }

    @Override
    public void disconnected(Line line) {
        kernel.disconnected(line);
        gait.drive(kernel.nowMs(), stepMs);
    }

    @Override
    public void step(double seconds) {
        if (battery.isEmpty()) {
            body.velocity(0, 0);
            return;
        }
        stepMs = seconds * 1000;
        double before = kernel.nowMs();
        kernel.advanceTo(before + stepMs);
        gait.count(before, stepMs);
        devices.joints().values().forEach(joint -> joint.step(seconds));
        battery.drain(seconds);
        if (kernel.nowMs() >= nextCycleMs - ROUNDING_MS) {
            nextCycleMs += Server.CYCLE_MS;
            camera.cycle();
            kernel.cycle();
        }
        gait.drive(kernel.nowMs(), stepMs);
    }

    @Override
    public long restNanos() {
        return gait.isAtRest() && areJointsAtRest() ? Math.round((nextCycleMs - kernel.nowMs()) * 1e6) : 0;
    }

    private boolean areJointsAtRest() {
        for (Joint joint : devices.joints().values()) {
            if (!joint.isAtRest()) {
                return false;
            }
        }
        return true;
    }

    @Override
    public void rest(long nanos) {
        if (!battery.isEmpty()) {
            kernel.advanceTo(kernel.nowMs() + nanos / 1e6);
            battery.drain(nanos / 1e9);
        }
    }

    private void install() {
        sensors.install(kernel.memory().variables());
        Functions functions = kernel.functions();
        functions.lasting("robot.walk", 1, GaitTask.function(gait, false));
        functions.lasting("robot.turn", 1, GaitTask.function(gait, true));
        functions.lasting("lab.stepwalk", 1, GaitTask.steps(gait, false));
        functions.lasting("lab.stepturn", 1, GaitTask.steps(gait, true));
        functions.builtIn("lab.posture", arguments -> Value.of(orientation.guess()));
        functions.builtIn("power", arguments -> Value.of(battery.percent() / 100.0));
        speaker.install();
        microphone.install();
        camera.install();
        new MemoryStick(
                        MemoryStickScript.program(kernel.memory().groups().leaves("hardware")),
                        MemoryStickScript.CLIENT)
                .insertInto(kernel);
    }
}
