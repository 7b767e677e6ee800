package majic.mavlink.session;

import java.io.IOException;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.driver.FirstBytes;
import majic.driver.RobotWait;
import majic.mavlink.frame.FrameCounts;
import majic.mavlink.frame.MavlinkEncoder;
import majic.mavlink.frame.MavlinkFrame;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.line.FrameListener;
import majic.mavlink.line.VehicleEndpoint;
import majic.mavlink.line.VehicleLine;
import majic.mavlink.line.VehicleLines;
import majic.mavlink.message.AutopilotVersion;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.ParameterValue;
import majic.mavlink.message.StatusPiece;
import majic.mavlink.message.VehicleHeartbeat;
import majic.time.SuspendDetector;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * One connection to one vehicle. Messages are handled on the reader thread of the connection; everything else may be
 * called from any thread.
 */
public final class VehicleSession {
    private static final int OPEN_MS = 3000;

    /** Vehicles send a heartbeat each second. */
    private static final double FIRST_HEARTBEAT_S = 5;

    /** Within this time each vehicle of the connection has sent one. */
    private static final double OTHERS_S = 1.2;

    private static final double PARAMETERS_S = 1;

    /** A vehicle that has sent nothing for so long is lost, seconds (MAVLink sheet 3). */
    private static final double SILENCE_S = 3;

    private static final String ASLEEP = "this computer was asleep";

    private final VehicleEndpoint endpoint;
    private final RobotWait waiting;
    private final TimeSource time;
    private final Listener listener;
    private final VehicleReports reports;
    private final StatusTexts texts;
    private final CommandSender commands;
    private final AutopilotParameters parameters;
    private final DataRates rates;
    private final SuspendDetector suspend = new SuspendDetector();
    private final AtomicBoolean over = new AtomicBoolean();
    private final AtomicBoolean toldOfTwo = new AtomicBoolean();
    private volatile int system;
    private volatile @Nullable VehicleLine line;
    private volatile @Nullable VehicleHeartbeat first;
    private volatile FlightModes modes;
    private volatile long heardNanos;
    private final NumberCheck numbers;
    private volatile boolean doubled;
    private boolean asleep;

    /** Is notified of what happens, on the reader thread. */
    public interface Listener {
        /** The position or the attitude is a new one. */
        void moved(VehicleSession session);

        /** A heartbeat has come. */
        void heartbeat(VehicleSession session, VehicleHeartbeat heartbeat);

        /** A message of another kind has come: parameters may have changed. */
        void reported(VehicleSession session, MavlinkMessageType type);

        /** The autopilot has restarted. */
        void restarted(VehicleSession session);

        /** Another vehicle sends with the same number from the same address; called once. */
        void doubled(VehicleSession session);

        /** The connection has ended; called once, on any thread. */
        void lost(VehicleSession session, LinkLost cause);

        /** The autopilot has sent a text. */
        void said(VehicleSession session, String text);

        /** Whether a text of the autopilot follows from what MAJIC does, so that the user needs no notice of it. */
        boolean isExpected(String text);

        /** A message for the user. */
        void notice(String message);
    }

    /**
     * Creates a session; opens nothing.
     *
     * @param wantedSystem of the vehicle; 0 for the only one
     */
    public VehicleSession(VehicleEndpoint endpoint, int wantedSystem, RobotWait waiting, Listener listener) {
        this.endpoint = endpoint;
        this.system = wantedSystem;
        this.waiting = waiting;
        this.time = waiting.time();
        this.listener = listener;
        this.reports = new VehicleReports(time);
        this.texts = new StatusTexts(time, listener::notice, listener::isExpected);
        this.commands = new CommandSender(this, time);
        this.parameters = new AutopilotParameters(this, waiting);
        this.numbers = new NumberCheck(time);
        this.rates = new DataRates(this, reports, time, listener::notice);
        this.modes = FlightModes.of(new VehicleHeartbeat(0, 0, 0, false, 0));
    }

    /**
     * Connects without moving or arming anything. Leaves nothing open when it throws.
     *
     * @throws ConnectFailed if there is no such vehicle, or it is not clear which one is meant
     */
    public void open() {
        try {
            line = VehicleLines.join(endpoint, OPEN_MS, time, new Handler());
        } catch (IOException e) {
            throw ConnectFailed.of(e);
        }
        try {
            heartbeat();
            VehicleHeartbeat found = find();
            first = found;
            modes = FlightModes.of(found);
            heardNanos = time.nanos();
            listener.heartbeat(this, found);
            rates.request();
            parameters.request("FS_GCS_ENABLE", "FS_ACTION", "WP_SPEED", "CRUISE_SPEED");
            send(MavlinkRequests.command(
                    system, MavlinkRequests.REQUEST_MESSAGE, 0, MavlinkMessageType.AUTOPILOT_VERSION.id()));
            waiting.awaitConnecting(
                    () -> over.get()
                            || parameters.known("FS_GCS_ENABLE").isPresent()
                                    && version().isPresent(),
                    PARAMETERS_S);
            failIfOver();
        } catch (RuntimeException e) {
            close();
            throw e;
        }
    }

    private VehicleHeartbeat find() {
        boolean any = waiting.awaitConnecting(() -> over.get() || wanted() != null, FIRST_HEARTBEAT_S);
        failIfOver();
        if (any && system == 0) {
            waiting.awaitConnecting(over::get, OTHERS_S);
            failIfOver();
        }
        Map<Integer, VehicleHeartbeat> all = line().autopilots();
        if (system == 0 && all.size() > 1) {
            throw new ConnectFailed(
                    Reason.OTHER,
                    "several vehicles send to " + endpoint.title() + ": " + listed(all)
                            + "; name one of them, as ?system="
                            + all.keySet().iterator().next());
        }
        VehicleHeartbeat found = wanted();
        if (found == null) {
            throw notFound(all);
        }
        system = system == 0 ? all.keySet().iterator().next() : system;
        return found;
    }

    private @Nullable VehicleHeartbeat wanted() {
        Map<Integer, VehicleHeartbeat> all = line().autopilots();
        return system == 0 ? all.values().stream().findFirst().orElse(null) : all.get(system);
    }

    private ConnectFailed notFound(Map<Integer, VehicleHeartbeat> others) {
        if (!others.isEmpty()) {
            return new ConnectFailed(
                    Reason.OTHER,
                    "no vehicle with system " + system + " sends to " + endpoint.title() + "; there are "
                            + listed(others));
        }
        FirstBytes bytes = line().firstBytes();
        if (bytes.isEmpty()) {
            return new ConnectFailed(
                    Reason.NO_ANSWER,
                    "no vehicle has sent anything to " + endpoint.title() + " within " + Math.round(FIRST_HEARTBEAT_S)
                            + " s");
        }
        String text = bytes.line();
        return new ConnectFailed(
                Reason.WRONG_DEVICE,
                endpoint.title() + " sends no heartbeat of an autopilot"
                        + (text == null ? "" : "; it begins with \"" + text + "\""));
    }

    /** Lists vehicles for users: {@code 1 (rover), 3 (copter)}. */
    public static String listed(Map<Integer, VehicleHeartbeat> vehicles) {
        return vehicles.entrySet().stream()
                .map(one ->
                        one.getKey() + " (" + VehicleClass.of(one.getValue()).title() + ")")
                .collect(Collectors.joining(", "));
    }

    private void failIfOver() {
        if (over.get()) {
            throw new ConnectFailed(Reason.OTHER, endpoint.title() + ": the connection ended while connecting");
        }
    }

    private VehicleLine line() {
        VehicleLine open = line;
        if (open == null) {
            throw new LinkLost("not connected");
        }
        return open;
    }

    /**
     * Sends a message; takes no longer than the write deadline of the link.
     *
     * @throws LinkLost if the connection has ended
     */
    public void send(OutgoingMessage message) {
        try {
            line().send(system, message);
        } catch (IOException e) {
            throw new LinkLost(String.valueOf(e.getMessage()), e);
        }
    }

    /** Sends the heartbeat that shows that this program runs, once a second, from the timer thread of the robot. */
    public void heartbeat() {
        VehicleLine open = line;
        if (open == null || over.get()) {
            return;
        }
        try {
            if (first == null) {
                open.sendToAll(MavlinkRequests.heartbeat());
            } else {
                open.send(system, MavlinkRequests.heartbeat());
            }
        } catch (IOException e) {
            end(new LinkLost("connection lost: " + e.getMessage(), e));
        }
    }

    /**
     * Finds out whether the computer was suspended or the vehicle is silent, and asks again for reports that do not
     * come; called often.
     */
    public void check() {
        if (first == null || over.get()) {
            return;
        }
        if (wasAsleep()) {
            end(new LinkLost(ASLEEP));
            return;
        }
        if (time.secondsSince(heardNanos) > SILENCE_S) {
            end(new LinkLost("connection lost: the vehicle has been silent for " + Math.round(SILENCE_S) + " s"));
            return;
        }
        rates.check();
        parameters.check();
    }

    /**
     * Refuses to move the vehicle after this computer was suspended: what was commanded before must not go on by
     * itself.
     *
     * @throws LinkLost if it was; the connection ends
     */
    public void refuseAfterSuspend() {
        if (wasAsleep()) {
            LinkLost cause = new LinkLost(ASLEEP);
            // On another thread: this one may hold locks that the end of the session needs.
            time.runAsync("mavlink suspended", () -> WaitPolicy.without(() -> end(cause)));
            throw cause;
        }
    }

    private synchronized boolean wasAsleep() {
        asleep |= suspend.wasSuspended();
        return asleep;
    }

    /** The number of the vehicle. */
    public int system() {
        return system;
    }

    /** Where it is reached. */
    public VehicleEndpoint endpoint() {
        return endpoint;
    }

    /** The newest messages. */
    public VehicleReports reports() {
        return reports;
    }

    /** The texts of the autopilot. */
    public StatusTexts texts() {
        return texts;
    }

    /** The commands to the autopilot. */
    public CommandSender commands() {
        return commands;
    }

    /** The parameters of the autopilot. */
    public AutopilotParameters parameters() {
        return parameters;
    }

    /** The modes of the vehicle. */
    public FlightModes modes() {
        return modes;
    }

    /** The kind of the vehicle. */
    public VehicleClass vehicle() {
        VehicleHeartbeat found = first;
        return found == null ? VehicleClass.OTHER : VehicleClass.of(found);
    }

    /** The newest heartbeat of the autopilot. */
    public VehicleHeartbeat newestHeartbeat() {
        return reports.newest(VehicleHeartbeat.class)
                .map(Received::value)
                .orElseGet(() -> Objects.requireNonNull(first, "a heartbeat comes before a session is open"));
    }

    /** The version of the firmware; empty if it was not reported. */
    public Optional<AutopilotVersion> version() {
        return reports.newest(AutopilotVersion.class).map(Received::value);
    }

    /** What has arrived. */
    public FrameCounts counts() {
        VehicleLine open = line;
        return open == null ? FrameCounts.NONE : open.counts(system);
    }

    /** Whether another vehicle sends with the same number from the same address: every message may be of either. */
    public boolean isDoubled() {
        return doubled;
    }

    /**
     * Does nothing if the vehicle is the only one with its number.
     *
     * @throws MotionFailed if it is not: what moves it would move the other one too
     */
    public void failIfDoubled() {
        if (doubled) {
            throw new MotionFailed("two vehicles send with the number " + system + " from one address; give one of them"
                    + " another SYSID_THISMAV, and connect again");
        }
    }

    /** Whether the connection has ended. */
    public boolean hasEnded() {
        return over.get();
    }

    /** Ends the connection; throws nothing. */
    public void close() {
        over.set(true);
        VehicleLine open = line;
        if (open != null) {
            open.close();
        }
        waiting.changes().raise();
    }

    /** Ends the session as a lost one, once. */
    public void end(LinkLost cause) {
        if (over.compareAndSet(false, true)) {
            VehicleLine open = line;
            if (open != null) {
                open.close();
            }
            listener.lost(this, cause);
            waiting.changes().raise();
        }
    }

    /** Sorts what arrives. */
    private final class Handler implements FrameListener {
        @Override
        public int system() {
            return system;
        }

        @Override
        public void received(MavlinkFrame frame) {
            if (first == null) {
                waiting.changes().raise();
            }
            if (frame.system() != system || over.get()) {
                return;
            }
            heardNanos = time.nanos();
            if (frame.isOfAutopilot()) {
                take(frame);
            }
        }

        private void take(MavlinkFrame frame) {
            if (frame.type() == MavlinkMessageType.HEARTBEAT
                    && !VehicleHeartbeat.of(frame.payload()).isOfAutopilot()) {
                return;
            }
            reports.take(frame);
            switch (frame.type()) {
                case HEARTBEAT -> {
                    VehicleHeartbeat heartbeat = VehicleHeartbeat.of(frame.payload());
                    handle(numbers.heartbeat(heartbeat));
                    listener.heartbeat(VehicleSession.this, heartbeat);
                }
                case COMMAND_ACK -> {
                    if (CommandAck.isFor(frame.payload(), MavlinkEncoder.SYSTEM, MavlinkEncoder.COMPONENT)) {
                        commands.take(CommandAck.of(frame.payload()));
                    }
                }
                case PARAM_VALUE -> parameters.take(ParameterValue.of(frame.payload()));
                case STATUSTEXT -> {
                    String text = texts.take(StatusPiece.of(frame.payload()));
                    if (!text.isEmpty()) {
                        listener.said(VehicleSession.this, text);
                    }
                }
                case ATTITUDE -> {
                    handle(numbers.clock(frame.payload().u32(0)));
                    listener.reported(VehicleSession.this, frame.type());
                }
                case LOCAL_POSITION_NED -> listener.moved(VehicleSession.this);
                default -> listener.reported(VehicleSession.this, frame.type());
            }
            waiting.changes().raise();
        }

        private void handle(NumberCheck.Finding finding) {
            if (finding == NumberCheck.Finding.RESTARTED && !doubled) {
                rates.restarted();
                listener.restarted(VehicleSession.this);
            }
            if (finding == NumberCheck.Finding.TWO && !doubled) {
                doubled = true;
                listener.doubled(VehicleSession.this);
                listener.notice(
                        "two vehicles send with the number " + system + " from one address: MAJIC moves neither of"
                                + " them, and a stop goes to both; give one of them another SYSID_THISMAV, and connect again");
            }
        }

        @Override
        public void ignored(int other, String address) {
            if (first != null && other == system && toldOfTwo.compareAndSet(false, true)) {
                listener.notice("a second autopilot with the number " + other + " sends from " + address
                        + " and is ignored: if it is another vehicle, give it another SYSID_THISMAV");
            }
        }

        @Override
        public void ended(IOException cause) {
            end(new LinkLost("connection lost: " + cause.getMessage(), cause));
        }
    }
}
