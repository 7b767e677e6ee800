package majicsim.mavlink;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A vehicle with its autopilot, and its links to ground stations: a console over TCP, and a radio that sends datagrams.
 * It starts with its first link, as ArduPilot's own simulation does. Every method with the lab's lock held.
 */
public final class MavlinkVehicle implements Firmware {
    /** The port at which the first vehicle usually listens; each further one 10 above. */
    public static final int PORT = 5760;

    private static final int GUIDED_ITEM = 2;
    private static final int WAYPOINT = 16;
    private static final int MISSION_UNSUPPORTED = 3;

    private final VehicleOptions options;
    private final Body body;
    private final Board board;
    private final Vehicle vehicle;
    private final Telemetry telemetry;
    private final Commands commands;
    private final MavlinkHandling handling;
    private final List<Channel> channels = new ArrayList<>();
    private @Nullable Channel console;
    private boolean isOn;
    private boolean hasHome;
    private boolean hasOrigin;
    private boolean restarts;

    /**
     * A vehicle that waits for its first link.
     *
     * @param name of the robot
     * @param world the room; the vehicle adds its body
     * @param start its start pose
     * @param noise of its sensors
     * @param options its kind
     * @param system its system id, 1 to 255
     * @throws IllegalArgumentException if it does not fit there
     */
    public MavlinkVehicle(String name, World world, Pose start, Noise noise, VehicleOptions options, int system) {
        this.options = options;
        boolean flies = options.kind() == VehicleKind.COPTER;
        body = flies
                ? Body.disc(name, Copter.RADIUS_MM, start)
                : Body.box(name, Rover.HALF_LENGTH_MM, Rover.HALF_LENGTH_MM, Rover.HALF_WIDTH_MM, start);
        world.add(body);
        board = Board.of(options, system, noise);
        vehicle = flies ? new Copter(board, new Flight(world, body)) : new Rover(board, body);
        Point corner = flies
                ? new Point(Copter.RADIUS_MM, Copter.RADIUS_MM)
                : new Point(Rover.HALF_LENGTH_MM, Rover.HALF_WIDTH_MM);
        telemetry = new Telemetry(vehicle, new RangeFinders(world, body, noise.fork("ranges"), corner));
        commands = new Commands(vehicle, telemetry, () -> restarts = true);
        handling = new MavlinkHandling(vehicle, this::restart);
    }

    /**
     * Its body.
     *
     * @return the body, with the name of the robot
     */
    public Body body() {
        return body;
    }

    /**
     * What can be done to it.
     *
     * @return the same object at every call
     */
    public MavlinkHandling handling() {
        return handling;
    }

    /**
     * The plug of its radio: the same vehicle for lines without the console's text.
     *
     * @return a firmware that must not be stepped
     */
    public Firmware radio() {
        return new Firmware() {
            @Override
            public void connected(Line line) {
                join(line);
            }

            @Override
            public void received(Line line, byte[] bytes) {
                MavlinkVehicle.this.received(line, bytes);
            }

            @Override
            public void disconnected(Line line) {
                MavlinkVehicle.this.disconnected(line);
            }

            @Override
            public void step(double seconds) {}
        };
    }

    @Override
    public void connected(Line line) {
        boolean isFirst = !isOn;
        console = join(line);
        if (isFirst) {
            greet();
        }
    }

    private Channel join(Line line) {
        Channel channel = new Channel(line, options.version(), board.parameters());
        channels.add(channel);
        isOn = true;
        return channel;
    }

    private void greet() {
        if (console != null) {
            String text = "\n\nInit " + options.kind().firmware() + " V4.6.0 (c8c41833)\n\nFree RAM: 131072\n";
            console.sendText(text.getBytes(StandardCharsets.US_ASCII));
        }
    }

    @Override
    public void disconnected(Line line) {
        channels.removeIf(channel -> channel.isOf(line));
        console = console != null && console.isOf(line) ? null : console;
    }

    private void restart() {
        restarts = false;
        vehicle.restart();
        board.boot().restart();
        board.radio().restart();
        board.groundStation().restart();
        board.announcements().drain();
        hasHome = false;
        hasOrigin = false;
        channels.forEach(Channel::restart);
        greet();
    }

    @Override
    public void received(Line line, byte[] bytes) {
        for (Channel channel : List.copyOf(channels)) {
            if (channel.isOf(line)) {
                channel.read(bytes).forEach(frame -> handle(frame, channel));
            }
        }
        announce();
    }

    private void announce() {
        for (Message message : board.announcements().drain()) {
            channels.forEach(channel -> channel.send(message));
        }
    }

    private void handle(Frame frame, Channel channel) {
        Message message = frame.message();
        if (!isForMe(message)) {
            return;
        }
        boolean isMyGroundStation = frame.system() == (int) board.parameter("SYSID_MYGCS");
        switch (message.type()) {
            case HEARTBEAT -> heard(isMyGroundStation);
            case COMMAND_LONG, COMMAND_INT -> command(frame, channel);
            case SET_MODE -> setMode(frame, channel);
            case SET_POSITION_TARGET_LOCAL_NED -> aim(PositionTarget.of(message));
            case REQUEST_DATA_STREAM -> stream(message, channel);
            case PARAM_REQUEST_READ -> readParameter(message, channel);
            case PARAM_REQUEST_LIST -> channel.listParameters();
            case PARAM_SET -> setParameter(message, channel);
            case RC_CHANNELS_OVERRIDE -> override(message, isMyGroundStation);
            case MANUAL_CONTROL -> manualControl(message, isMyGroundStation);
            case MISSION_ITEM -> missionItem(frame, channel);
            case MISSION_COUNT -> acknowledgeMission(frame, channel, MISSION_UNSUPPORTED);
            case MISSION_CLEAR_ALL -> acknowledgeMission(frame, channel, 0);
            case MISSION_REQUEST_LIST ->
                channel.send(new Message(MessageType.MISSION_COUNT)
                        .with("target_system", frame.system())
                        .with("target_component", frame.component()));
            default -> {}
        }
    }

    private boolean isForMe(Message message) {
        return isOneOf(message, message.has("target_system") ? "target_system" : "target", "SYSID_THISMAV")
                && (!message.has("target_component") || message.integer("target_component") <= 1);
    }

    private boolean isOneOf(Message message, String field, String parameter) {
        return !message.has(field)
                || message.integer(field) == 0
                || message.integer(field) == (int) board.parameter(parameter);
    }

    private void heard(boolean isMyGroundStation) {
        if (isMyGroundStation) {
            board.groundStation().heard();
        }
    }

    private void command(Frame frame, Channel channel) {
        Command command = Command.of(frame.message());
        acknowledge(command.number(), commands.carryOut(command, channel), frame, channel);
        if (restarts) {
            restart();
        }
    }

    private static void acknowledge(int command, CommandResult result, Frame frame, Channel channel) {
        channel.send(new Message(MessageType.COMMAND_ACK)
                .with("command", command)
                .with("result", result.ordinal())
                .with("target_system", frame.system())
                .with("target_component", frame.component()));
    }

    private void aim(PositionTarget target) {
        if (target.isFinite()) {
            vehicle.aim(target);
        }
    }

    /** Without the bit for a custom mode it is not answered (sheet 8). */
    private void setMode(Frame frame, Channel channel) {
        if ((frame.message().integer("base_mode") & Vehicle.CUSTOM) != 0) {
            CommandResult result = vehicle.change(frame.message().integer("custom_mode"));
            acknowledge(MessageType.SET_MODE.id(), result, frame, channel);
        }
    }

    private static void stream(Message message, Channel channel) {
        boolean starts = message.integer("start_stop") == 1;
        channel.streams().rate(message.integer("req_stream_id"), starts ? message.integer("req_message_rate") : 0);
    }

    /** An unknown parameter is not answered. */
    private void readParameter(Message message, Channel channel) {
        int index = message.integer("param_index");
        if (index >= 0) {
            String name = board.parameters().name(index);
            if (name != null) {
                channel.send(board.parameters().message(name, index));
            }
        } else if (board.parameters().has(message.text("param_id"))) {
            channel.send(board.parameters().message(message.text("param_id"), Parameters.NO_INDEX));
        }
    }

    private void setParameter(Message message, Channel channel) {
        String name = message.text("param_id");
        double value = message.number("param_value");
        if (board.parameters().has(name) && Double.isFinite(value)) {
            board.parameters().set(name, value);
            channel.send(board.parameters().message(name, Parameters.NO_INDEX));
        }
    }

    private void override(Message message, boolean isMyGroundStation) {
        if (isMyGroundStation) {
            board.groundStation().heard();
            board.radio().override(message);
        }
    }

    private void manualControl(Message message, boolean isMyGroundStation) {
        if (!isMyGroundStation) {
            return;
        }
        RadioControl radio = board.radio();
        if (options.kind() == VehicleKind.COPTER) {
            radio.overrideBy(1, message.integer("y"));
            radio.overrideBy(2, -message.integer("x"));
            radio.overrideBy(3, 2 * message.integer("z") - 1000);
            radio.overrideBy(4, message.integer("r"));
        } else {
            radio.overrideBy(1, message.integer("y"));
            radio.overrideBy(3, message.integer("z"));
        }
    }

    /** The old way to send a vehicle to a place; missions themselves are not supported. */
    private void missionItem(Frame frame, Channel channel) {
        Message item = frame.message();
        boolean isPlace = item.integer("current") == GUIDED_ITEM && item.integer("command") == WAYPOINT;
        boolean isDone = isPlace
                && vehicle.mode() == vehicle.guidedMode()
                && commands.goTo(
                        item.number("x") * 1e7, item.number("y") * 1e7, item.integer("frame"), item.number("z"));
        acknowledgeMission(frame, channel, isDone ? 0 : isPlace ? 1 : MISSION_UNSUPPORTED);
    }

    private static void acknowledgeMission(Frame frame, Channel channel, int type) {
        channel.send(new Message(MessageType.MISSION_ACK)
                .with("target_system", frame.system())
                .with("target_component", frame.component())
                .with("type", type));
    }

    @Override
    public void step(double seconds) {
        if (!isOn) {
            return;
        }
        Boot boot = board.boot();
        boot.step(seconds);
        board.filter().step(seconds);
        board.groundStation().step(seconds);
        setHomeAndOrigin(boot);
        vehicle.step(seconds);
        announce();
        long now = boot.nanos();
        for (Channel channel : channels) {
            channel.step();
            channel.streams().due(now).forEach(type -> telemetry.messages(type).forEach(channel::send));
        }
    }

    private void setHomeAndOrigin(Boot boot) {
        if (boot.hasOrigin() && !hasOrigin) {
            hasOrigin = true;
            board.filter().origin(vehicle.motion());
        }
        if (boot.hasFix() && !hasHome) {
            hasHome = true;
            board.filter().home(vehicle.motion());
        }
    }

    @Override
    public long restNanos() {
        if (!isOn) {
            return Long.MAX_VALUE;
        }
        boolean rests = vehicle.isResting();
        boolean isWatching = board.parameter("FS_GCS_ENABLE") != 0;
        if (!rests || isWatching || !board.boot().isOver() || channels.stream().anyMatch(Channel::isListing)) {
            return 0;
        }
        long now = board.boot().nanos();
        long due = board.filter().dueNanos() + now;
        for (Channel channel : channels) {
            due = Math.min(due, channel.streams().dueNanos());
        }
        return Math.max(0, due - now);
    }
}
