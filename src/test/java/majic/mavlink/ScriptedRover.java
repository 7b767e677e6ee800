package majic.mavlink;

import static majic.mavlink.VehicleFrames.fields;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import majic.bot.Pose;

/**
 * A vehicle with ArduPilot as the sheet describes it, stepped one millisecond at a time: modes, arming, velocities that
 * end after 3 s, a first-order response, positions, parameters. Not thread-safe: for the thread of its peer.
 */
final class ScriptedRover {
    static final int HOLD = 4;
    static final int GUIDED = 15;

    private static final double FASTEST_MM_PER_SEC = 2000;
    private static final double LAG_S = 0.2;
    private static final int TARGET_MS = 3000;
    private static final double EARTH_MM_PER_DEG = Math.toRadians(6_371_000_000.0);

    final List<VehicleFrames.Got> received = new ArrayList<>();
    final Map<String, Float> parameters = new HashMap<>(Map.of("FS_GCS_ENABLE", 0f, "FS_ACTION", 2f, "WP_SPEED", 2f));
    private final VehicleFrames frames = new VehicleFrames();
    private final Consumer<byte[]> output;
    private final Map<Integer, Integer> periodsMs = new HashMap<>();
    volatile int system = 1;
    volatile int component = 1;
    volatile int type = 10;
    volatile int autopilot = 3;
    volatile int version = 2;
    volatile int mode;
    volatile int status = 4;
    volatile boolean heartless;
    volatile boolean armed;
    volatile boolean silent;
    volatile boolean blocked;
    volatile boolean positionless;
    volatile boolean ignoresModes;
    volatile int landed = 1;
    volatile int lostIndex = -1;

    /** The first request for this message is lost on the way. */
    volatile int lostRequest = -1;

    /** Before a parameter is set, its old value is sent twice; the answer comes 200 ms later. */
    volatile boolean sendsOldValues;

    volatile boolean keepsParameters;

    /** How long it ran before the test, ms. */
    volatile int ranMs;

    /** Of the version of its firmware; 0 for one that does not report it. */
    volatile int major = 4;

    private String dueAnswer = "";
    private long dueAnswerMs;
    volatile double heightMm;
    volatile boolean withoutPosition;
    volatile boolean withoutAttitude;
    volatile boolean withoutLandedState;
    volatile int positionLagMs;
    volatile int armingMs;

    /** As by a radio that carries no more. */
    volatile int leastPeriodMs;

    List<ByteBuffer> batteries = List.of();
    private long armedMs = Long.MAX_VALUE;
    volatile boolean onlyAnswers;
    volatile int answeredSystem;
    volatile String armRefusal = "";
    volatile String modeRefusal = "";
    volatile int refusedMode = -1;
    volatile Pose pose = Pose.START;
    Pose frame = new Pose(12_000, -5_000, 70);
    private double wantedMmPerSec;
    private double wantedDegPerSec;
    private double climbMmPerSec;
    private double mmPerSec;
    private double degPerSec;
    private long targetMs;
    private long nowMs;
    private long bootMs;
    volatile boolean congested;
    private double lateMs;
    private final Deque<byte[]> queue = new ArrayDeque<>();
    private final Deque<Long> dueMs = new ArrayDeque<>();
    private double goalMm = Double.NaN;

    ScriptedRover(Consumer<byte[]> output) {
        this.output = output;
    }

    /** Starts anew, as after a loss of power. */
    void restart() {
        bootMs = nowMs;
        periodsMs.clear();
        armed = false;
        mode = 0;
        wantedMmPerSec = 0;
        wantedDegPerSec = 0;
    }

    void receive(byte[] bytes) {
        for (VehicleFrames.Got got : frames.read(bytes)) {
            if (!isForAnother(got)) {
                received.add(got);
                if (!silent) {
                    obey(got);
                }
            }
        }
    }

    private boolean isForAnother(VehicleFrames.Got got) {
        Integer offset = Map.of(76, 30, 75, 30, 84, 50, 20, 2, 23, 4, 66, 2).get(got.id());
        return offset != null && got.u8(offset) != system;
    }

    private void obey(VehicleFrames.Got got) {
        switch (got.id()) {
            case 76 -> command(got, got.u16(28));
            case 75 -> reposition(got);
            case 84 -> target(got);
            case 20 -> {
                int index = got.u16(0);
                if (index == 65_535) {
                    parameter(got.text(4, 16));
                } else {
                    listed(index);
                }
            }
            case 21 -> {
                for (int index = 0; index < parameters.size(); index++) {
                    if (index != lostIndex) {
                        listed(index);
                    }
                }
            }
            case 23 -> setParameter(got.text(6, 16), got.f32(0));
            default -> {}
        }
    }

    private void setParameter(String name, float value) {
        if (sendsOldValues) {
            parameter(name);
            listed(parameters.keySet().stream().sorted().toList().indexOf(name));
        }
        if (!keepsParameters) {
            parameters.computeIfPresent(name, (key, before) -> value);
        }
        if (sendsOldValues) {
            dueAnswer = name;
            dueAnswerMs = nowMs + 200;
        } else {
            parameter(name);
        }
    }

    private void command(VehicleFrames.Got got, int command) {
        switch (command) {
            case 176 -> setMode(Math.round(got.f32(4)));
            case 400 -> arm(got.f32(0) == 1);
            case 22 -> {
                landed = 2;
                heightMm = 1000 * got.f32(24);
                acknowledge(22, 0);
            }
            case 511 -> {
                if (Math.round(got.f32(0)) == lostRequest) {
                    lostRequest = -1;
                    return;
                }
                periodsMs.put(Math.round(got.f32(0)), Math.round(got.f32(4) / 1000));
                acknowledge(511, 0);
            }
            case 512 -> {
                acknowledge(512, major == 0 ? 3 : 0);
                if (major > 0) {
                    send(148, fields(78).put(18, (byte) 6).put(19, (byte) major));
                }
            }
            default -> acknowledge(command, 3);
        }
    }

    private void setMode(int wanted) {
        if (ignoresModes) {
            return;
        }
        if (wanted == refusedMode) {
            acknowledge(176, 4);
            return;
        }
        if (!modeRefusal.isEmpty()) {
            acknowledge(176, 4);
            text(modeRefusal);
            return;
        }
        acknowledge(176, 0);
        changeMode(onlyAnswers ? mode : wanted);
    }

    /** Changes the mode, as a command or the radio control does. */
    void changeMode(int wanted) {
        if (mode != wanted) {
            wantedMmPerSec = 0;
            wantedDegPerSec = 0;
            goalMm = Double.NaN;
        }
        mode = wanted;
        heartbeat();
    }

    private void arm(boolean wanted) {
        if (wanted && !armRefusal.isEmpty()) {
            acknowledge(400, 4);
            text(armRefusal);
            return;
        }
        if (armingMs > 0) {
            acknowledge(400, 5);
            armedMs = nowMs + armingMs;
            return;
        }
        armed = onlyAnswers ? armed : wanted;
        acknowledge(400, 0);
    }

    /** Answers every 2 s that it is still arming. */
    private void goOnArming() {
        if (nowMs == armedMs) {
            armed = true;
            acknowledge(400, 0);
        } else if (armedMs - nowMs < armingMs && (armedMs - nowMs) % 2000 == 0) {
            acknowledge(400, 5);
        }
    }

    private void reposition(VehicleFrames.Got got) {
        if (got.u16(28) == 192) {
            mode = guided();
            acknowledge(192, 0);
            goalMm = (got.i32(16) / 1e7 - 47) * EARTH_MM_PER_DEG;
        }
    }

    private int guided() {
        return type == 10 || type == 11 ? GUIDED : 4;
    }

    private void target(VehicleFrames.Got got) {
        int mask = got.u16(48);
        if (mode != guided()
                || !armed
                || got.u8(52) != 8
                || mask != 0x05E7 && mask != 0x05FF && (type != 2 || mask != 0x05C7 || landed != 2)) {
            return;
        }
        targetMs = nowMs;
        goalMm = Double.NaN;
        climbMmPerSec = mask == 0x05C7 ? -1000 * got.f32(24) : 0;
        wantedMmPerSec = mask == 0x05FF ? 0 : 1000 * got.f32(16);
        wantedDegPerSec = -Math.toDegrees(got.f32(44));
        wantedMmPerSec = Math.max(-FASTEST_MM_PER_SEC, Math.min(FASTEST_MM_PER_SEC, wantedMmPerSec));
    }

    private void listed(int index) {
        parameter(parameters.keySet().stream().sorted().toList().get(index), index, parameters.size());
    }

    private void parameter(String name) {
        parameter(name, -1, 1235);
    }

    private void parameter(String name, int index, int count) {
        Float value = parameters.get(name);
        if (value != null) {
            send(
                    22,
                    fields(25)
                            .putFloat(value)
                            .putShort((short) count)
                            .putShort((short) index)
                            .put(Arrays.copyOf(name.getBytes(StandardCharsets.US_ASCII), 16))
                            .put((byte) (name.equals("WP_SPEED") ? 9 : 2)));
        }
    }

    private void acknowledge(int command, int result) {
        send(77, fields(10).putShort((short) command).put((byte) result).put(8, (byte) answeredSystem));
    }

    void text(String text) {
        send(253, fields(54).put((byte) 2).put(Arrays.copyOf(text.getBytes(StandardCharsets.US_ASCII), 50)));
    }

    void send(int id, ByteBuffer fields) {
        if (!silent) {
            queue.add(frames.frame(version, system, component, id, fields));
            dueMs.add(nowMs + (long) lateMs);
            deliver();
        }
    }

    private void deliver() {
        while (!dueMs.isEmpty() && dueMs.getFirst() <= nowMs) {
            dueMs.removeFirst();
            output.accept(queue.removeFirst());
        }
    }

    private void heartbeat() {
        send(
                0,
                fields(9)
                        .putInt(mode)
                        .put((byte) type)
                        .put((byte) autopilot)
                        .put((byte) (1 | (armed ? 128 : 0)))
                        .put((byte) status)
                        .put((byte) 3));
    }

    /** Lets a millisecond pass. */
    void step() {
        nowMs++;
        if (nowMs == dueAnswerMs) {
            parameter(dueAnswer);
        }
        lateMs += congested ? 0.5 : 0;
        deliver();
        goOnArming();
        drive();
        int ms = (int) (nowMs - bootMs) + ranMs;
        if (!heartless && due(0, 1000)) {
            heartbeat();
        }
        double north = frame.plus(pose).xMm() / 1000;
        double west = frame.plus(pose).yMm() / 1000;
        double yaw = -Math.toRadians(frame.plus(pose).headingDeg());
        if (!withoutAttitude && due(30, 1000)) {
            send(
                    30,
                    fields(28)
                            .putInt(ms)
                            .putFloat(0)
                            .putFloat(0)
                            .putFloat((float) yaw)
                            .putFloat(0)
                            .putFloat(0)
                            .putFloat((float) -Math.toRadians(degPerSec)));
        }
        if (!withoutPosition && due(32, 1000)) {
            double speed = mmPerSec / 1000;
            boolean none = positionless;
            send(
                    32,
                    fields(28)
                            .putInt(ms - positionLagMs)
                            .putFloat(none ? 0 : (float) north)
                            .putFloat(none ? 0 : (float) -west)
                            .putFloat(0)
                            .putFloat(none ? 0 : (float) (speed * Math.cos(yaw)))
                            .putFloat(none ? 0 : (float) (speed * Math.sin(yaw))));
        }
        if (due(33, 1000)) {
            send(
                    33,
                    positionless
                            ? fields(28)
                            : fields(28)
                                    .putInt(ms)
                                    .putInt(latitudeE7())
                                    .putInt(90_000_000)
                                    .putInt(0)
                                    .putInt((int) heightMm)
                                    .putShort(24, (short) (-climbMmPerSec / 10)));
        }
        if (type == 2 && periodsMs.containsKey(245) && !withoutLandedState && due(245, 1000)) {
            send(245, fields(2).put(1, (byte) landed));
        }
        if (due(24, 1000)) {
            send(24, fields(52).put(28, (byte) 3).put(29, (byte) 11));
        }
        if (due(147, 1000)) {
            batteries.forEach(battery -> send(147, battery));
        }
        if (due(1, 1000)) {
            send(1, fields(43).putShort(14, (short) 12_400).put(30, (byte) 80));
        }
    }

    private int latitudeE7() {
        return (int) Math.round(1e7 * (47 + frame.plus(pose).xMm() / EARTH_MM_PER_DEG));
    }

    private boolean due(int id, int usualMs) {
        return (nowMs + id) % Math.max(periodsMs.getOrDefault(id, usualMs), leastPeriodMs) == 0;
    }

    private void drive() {
        if (nowMs - targetMs > TARGET_MS || !armed || mode != guided()) {
            wantedMmPerSec = 0;
            wantedDegPerSec = 0;
            climbMmPerSec = 0;
        }
        goThere();
        heightMm += climbMmPerSec * 0.001;
        mmPerSec += (wantedMmPerSec - mmPerSec) * 0.001 / LAG_S;
        degPerSec += (wantedDegPerSec - degPerSec) * 0.001 / LAG_S;
        if (Math.abs(mmPerSec) < 1 && wantedMmPerSec == 0) {
            mmPerSec = 0;
        }
        if (Math.abs(degPerSec) < 0.1 && wantedDegPerSec == 0) {
            degPerSec = 0;
        }
        if (blocked) {
            mmPerSec = 0;
            degPerSec = 0;
        }
        pose = pose.after(mmPerSec / 1000, degPerSec / 1000);
    }

    /** By its own navigation, for a place to its north that it faces. */
    private void goThere() {
        if (!Double.isNaN(goalMm) && mode == guided() && armed) {
            double leftMm = goalMm - frame.plus(pose).xMm();
            wantedMmPerSec = Math.abs(leftMm) < 1000 ? 0 : Math.signum(leftMm) * 1000;
        }
    }

    double mmPerSec() {
        return mmPerSec;
    }

    /** A BATTERY_STATUS. */
    static ByteBuffer battery(int id, int millivolts, int percent) {
        ByteBuffer fields = fields(54);
        for (int cell = 0; cell < 10; cell++) {
            fields.putShort(10 + 2 * cell, (short) (cell == 0 ? millivolts : 0xFFFF));
        }
        return fields.put(32, (byte) id).put(35, (byte) percent);
    }

    /** The commands of a kind that have been received. */
    List<VehicleFrames.Got> commands(int command) {
        return received.stream()
                .filter(got -> got.id() == 76 && got.u16(28) == command)
                .toList();
    }

    /** The targets that have been received. */
    List<VehicleFrames.Got> targets() {
        return received.stream().filter(got -> got.id() == 84).toList();
    }
}
