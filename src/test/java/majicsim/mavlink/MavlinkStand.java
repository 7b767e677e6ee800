package majicsim.mavlink;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.FrameReader;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.pioneer.FakeLine;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;

/**
 * A vehicle in a hall of 100 x 100 m whose nose points north, and its ground station, which sends heartbeats while time
 * passes. Stepped by the test.
 */
final class MavlinkStand {
    static final int GUIDED = 15;
    static final int HOLD = 4;
    static final int FRAME_MAP = 1;
    static final int FRAME_BODY = 8;

    private static final double STEP_S = 0.004;
    private static final int STEPS_A_SECOND = 250;
    private static final int GROUND_STATION = 255;
    private static final String HALL = """
            2D-Map
            LineMinPos: -50000 -50000
            LineMaxPos: 50000 50000
            NumLines: 8
            LINES
            -50000 -50000 50000 -50000
            50000 -50000 50000 50000
            50000 50000 -50000 50000
            -50000 50000 -50000 -50000
            20000 -1000 21000 -1000
            21000 -1000 21000 1000
            21000 1000 20000 1000
            20000 1000 20000 -1000
            DATA
            """;

    private final World world;
    private final MavlinkVehicle vehicle;
    private final FakeLine line = new FakeLine();
    private final int version;
    private final FrameReader reader = new FrameReader();
    private final List<Frame> frames = new ArrayList<>();
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private int sequence;
    private int steps;
    private boolean isSilent;

    /** A vehicle at the middle of the hall without noise. */
    MavlinkStand(String model) {
        this(model, Noise.exact());
    }

    MavlinkStand(String model, Noise noise) {
        VehicleOptions options = VehicleOptions.parse(model);
        world = new World(hall());
        vehicle = new MavlinkVehicle("mavlink", world, new Pose(0, 0, 90), noise, options, 1);
        version = options.version();
        vehicle.connected(line);
        take();
    }

    private static Room hall() {
        try {
            return Room.parse(new StringReader(HALL), "hall");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    MavlinkHandling handling() {
        return vehicle.handling();
    }

    World world() {
        return world;
    }

    Pose pose() {
        return vehicle.body().pose();
    }

    /** Metres north of the start. */
    double north() {
        return pose().yMm() / 1000;
    }

    /** Metres east of the start. */
    double east() {
        return pose().xMm() / 1000;
    }

    double speed() {
        return vehicle.body().speedMmPerSec() / 1000;
    }

    /** Degrees clockwise from north, -180 to 180. */
    double yaw() {
        return Math.toDegrees(Motion.yawOf(pose().headingDeg()));
    }

    /** Degrees a second, clockwise. */
    double turning() {
        return -vehicle.body().turnDegPerSec();
    }

    void place(double northM, double eastM) {
        vehicle.body().place(new Pose(eastM * 1000, northM * 1000, pose().headingDeg()));
    }

    /** The ground station sends no heartbeats, or sends them again. */
    void silent(boolean silent) {
        isSilent = silent;
    }

    MavlinkStand pass(double seconds) {
        for (long left = Math.round(seconds * STEPS_A_SECOND); left > 0; left--) {
            if (steps % STEPS_A_SECOND == 0 && !isSilent) {
                heartbeat();
            }
            steps++;
            world.step(STEP_S);
            vehicle.step(STEP_S);
            take();
        }
        return this;
    }

    private void take() {
        for (byte[] piece : line.take()) {
            bytes.writeBytes(piece);
            frames.addAll(reader.feed(piece));
        }
    }

    byte[] bytes() {
        return bytes.toByteArray();
    }

    private void heartbeat() {
        send(new Message(MessageType.HEARTBEAT)
                .with("type", 6)
                .with("autopilot", 8)
                .with("system_status", 4)
                .with("mavlink_version", 3));
    }

    void send(Message message) {
        sendFrom(GROUND_STATION, message);
    }

    void sendFrom(int system, Message message) {
        sendBytes(new Frame(version, sequence++ & 0xFF, system, 190, message).toBytes());
    }

    void sendBytes(byte[] sent) {
        vehicle.received(line, sent);
        take();
    }

    /** Sends a COMMAND_LONG; returns its result, -1 without an answer. */
    int command(int number, double... params) {
        Message message = new Message(MessageType.COMMAND_LONG)
                .with("command", number)
                .with("target_system", 1)
                .with("target_component", 1);
        for (int i = 0; i < params.length; i++) {
            message.with("param" + (i + 1), params[i]);
        }
        int before = frames.size();
        send(message);
        return resultSince(before, number);
    }

    int resultSince(int before, int number) {
        return frames.subList(before, frames.size()).stream()
                .map(Frame::message)
                .filter(ack -> ack.type() == MessageType.COMMAND_ACK && ack.integer("command") == number)
                .mapToInt(ack -> ack.integer("result"))
                .findFirst()
                .orElse(-1);
    }

    int received() {
        return frames.size();
    }

    int mode(int number) {
        return command(176, 1, number);
    }

    int arm() {
        return command(400, 1);
    }

    /** Sends a velocity. */
    void velocity(int frame, int mask, double vx, double yawRate) {
        send(target(frame, mask).with("vx", vx).with("yaw_rate", yawRate));
    }

    /** Sends a velocity five times a second. */
    MavlinkStand stream(int frame, int mask, double vx, double yawRate, double seconds) {
        for (long left = Math.round(seconds * 5); left > 0; left--) {
            velocity(frame, mask, vx, yawRate);
            pass(0.2);
        }
        return this;
    }

    static Message target(int frame, int mask) {
        return new Message(MessageType.SET_POSITION_TARGET_LOCAL_NED)
                .with("target_system", 1)
                .with("target_component", 1)
                .with("coordinate_frame", frame)
                .with("type_mask", mask);
    }

    void set(String parameter, double value) {
        send(new Message(MessageType.PARAM_SET)
                .with("target_system", 1)
                .with("param_id", parameter)
                .with("param_value", value));
    }

    List<Message> all(MessageType type) {
        return frames.stream()
                .map(Frame::message)
                .filter(message -> message.type() == type)
                .toList();
    }

    Message last(MessageType type) {
        List<Message> all = all(type);
        return all.get(all.size() - 1);
    }

    /** Asks for a message and returns it. */
    Message ask(MessageType type) {
        command(512, type.id());
        pass(STEP_S);
        return last(type);
    }

    List<String> texts() {
        return all(MessageType.STATUSTEXT).stream()
                .map(message -> message.text("text"))
                .toList();
    }

    List<Frame> frames() {
        return List.copyOf(frames);
    }

    /** Forgets what was received. */
    void forget() {
        frames.clear();
    }

    /** A rover that is armed and guided. */
    static MavlinkStand guidedRover() {
        MavlinkStand stand = new MavlinkStand("rover+ready");
        stand.pass(0.1);
        stand.mode(GUIDED);
        stand.arm();
        return stand;
    }
}
