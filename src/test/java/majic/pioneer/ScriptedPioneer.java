package majic.pioneer;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.SipBytes;
import majic.pioneer.session.RampModel;
import majic.pioneer.state.Scaling;
import org.jspecify.annotations.Nullable;

/**
 * A Pioneer for tests behind a {@link SteppedPeer}: answers the handshake and sends SIPs from a model with ramps; tests
 * can add faults.
 */
public final class ScriptedPioneer implements SteppedPeer.Robot {
    private static final int LOST_STEP = 0xFF;

    /** Where fields are in the data of {@link Bytes#CONFIG}: SERNUM, FRONTSONAR, and after REARSONAR WATCHDOG. */
    private static final int SERIAL_NUMBER = 13;

    private static final int FRONT_SONAR = 41;

    private static final int WATCHDOG = 48;

    /** The commands received, as {@code "VEL 250"}, without the handshake. */
    public final List<String> heard = new CopyOnWriteArrayList<>();

    /** When they were received, ms. */
    final List<Long> heardAt = new CopyOnWriteArrayList<>();

    public final RampModel robot = new RampModel(300, 300, 100);
    final List<Double> speeds = new ArrayList<>();

    /** Three letters. */
    String serialNumber = "SIM";

    String subclass = "p3dx-sh";
    double mmPerCount = 1;
    int cycleMs = 100;
    int losesOneSipIn;
    int deadZone;
    DoubleUnaryOperator governor = speed -> speed;
    boolean wholeDegrees;
    boolean ignoresRamps;
    boolean ignoresEmergency;
    boolean answersConfig = true;
    int frontSonar = 1;
    int rearSonar = 1;
    int watchdogMs = 2000;
    boolean sonarsOff;

    /** Has a laser with three readings, as a simulator may. */
    boolean hasLaser;

    private boolean laserOn;
    boolean hangsUpAtClose = true;
    boolean miscountsAfterSonar;
    boolean held;
    boolean silent;
    volatile boolean motors;
    int stallBits;
    int extraFlags;
    int rejectsSyncs;
    int ignoresSyncs;
    boolean hangsUpAtSync;
    boolean inOpenSession;
    boolean neverEnables;
    int connections;
    long firstByteMs;
    private long connectedMs;

    private double up = 300;
    private double down = 300;
    private boolean shaken;
    private boolean sendsSips;
    private boolean lieNext;
    private long sips;

    /** Behaves as a robot does by the sheet. */
    public static ScriptedPioneer robot() {
        return new ScriptedPioneer();
    }

    /** Behaves as the vendor's simulator does (ARCOS sheet 5.2, 9.1, 14.2). */
    static ScriptedPioneer vendorSimulator() {
        ScriptedPioneer simulator = new ScriptedPioneer();
        simulator.subclass = "p3dx";
        simulator.mmPerCount = 0.485;
        simulator.wholeDegrees = true;
        simulator.miscountsAfterSonar = true;
        simulator.motors = true;
        return simulator;
    }

    /** Sends SIPs of a session that was left open. */
    static ScriptedPioneer inOpenSession() {
        ScriptedPioneer left = new ScriptedPioneer();
        left.inOpenSession = true;
        left.motors = true;
        left.hangsUpAtClose = false;
        return left;
    }

    ScriptedPioneer every(int milliseconds) {
        cycleMs = milliseconds;
        return this;
    }

    /** Zero for none. */
    ScriptedPioneer losingOneIn(int many) {
        losesOneSipIn = many;
        return this;
    }

    @Override
    public void connected(SteppedPeer line) {
        connections++;
        connectedMs = line.millis();
        firstByteMs = 0;
        shaken = inOpenSession;
        sendsSips = inOpenSession;
        laserOn = false;
        silent = false;
        inOpenSession = false;
    }

    @Override
    public void left() {
        sendsSips = false;
        motors = false;
        robot.freeze();
    }

    @Override
    public void received(SteppedPeer line, Packet packet) {
        firstByteMs = firstByteMs == 0 ? line.millis() - connectedMs : firstByteMs;
        if (!shaken) {
            sync(line, packet.type());
            return;
        }
        int value = argument(packet.data());
        heardAt.add(line.millis());
        heard.add(name(packet.type()) + " " + value);
        obey(line, packet.type(), value);
    }

    private static int argument(byte[] data) {
        if (data.length < 3) {
            return 0;
        }
        int magnitude = data[1] & 0xFF | (data[2] & 0xFF) << 8;
        return data[0] == 0x1B ? -magnitude : magnitude;
    }

    private void sync(SteppedPeer line, int step) {
        if (hangsUpAtSync) {
            line.hangUp();
        } else if (ignoresSyncs > 0) {
            ignoresSyncs--;
        } else if (step == 1 && rejectsSyncs > 0) {
            rejectsSyncs--;
            line.send(Bytes.wire(LOST_STEP, new byte[0]));
        } else if (step < 2) {
            line.send(Bytes.wire(step, new byte[0]));
        } else {
            shaken = true;
            line.send(Bytes.wire(2, ("Peer\0Pioneer\0" + subclass + "\0").getBytes(StandardCharsets.US_ASCII)));
        }
    }

    private void obey(SteppedPeer line, int number, int value) {
        switch (number) {
            case 1 -> sendsSips = true;
            case 2 -> endSession(line);
            case 4 -> enable(value != 0);
            case 5 -> accelerate(value);
            case 11 -> robot.speed((int) governor.applyAsDouble(moves(value) ? value : 0));
            case 18 -> config(line);
            case 21 -> robot.rate(moves(Integer.MAX_VALUE) ? value : 0);
            case 23 -> turnRamp(value);
            case 28 -> sonar(value);
            case 29 -> halt();
            case 55 -> emergency();
            case 230 -> laserOn = hasLaser && value == 1;
            default -> {}
        }
    }

    private void sonar(int value) {
        sonarsOff &= value != 1;
        lieNext = miscountsAfterSonar && value == 1;
    }

    private boolean moves(int speed) {
        return motors && !held && Math.abs(speed) >= deadZone;
    }

    private void halt() {
        robot.speed(0);
        robot.rate(0);
    }

    private void emergency() {
        if (ignoresEmergency) {
            halt();
        } else {
            robot.freeze();
        }
    }

    private void enable(boolean on) {
        motors = on && !neverEnables;
        if (!motors) {
            halt();
        }
    }

    private void accelerate(int value) {
        if (!ignoresRamps) {
            up = value > 0 ? value : up;
            down = value < 0 ? -value : down;
            robot.ramps(up, down);
        }
    }

    private void turnRamp(int value) {
        if (!ignoresRamps) {
            robot.turnRamp(Math.abs(value));
        }
    }

    private void endSession(SteppedPeer line) {
        sendsSips = false;
        shaken = false;
        enable(false);
        if (hangsUpAtClose) {
            line.hangUp();
        }
    }

    private void config(SteppedPeer line) {
        if (answersConfig) {
            byte[] whole = Bytes.of(Bytes.CONFIG);
            byte[] data = Arrays.copyOfRange(whole, 4, whole.length - 2);
            byte[] serial = serialNumber.getBytes(StandardCharsets.US_ASCII);
            System.arraycopy(serial, 0, data, SERIAL_NUMBER, serial.length);
            data[FRONT_SONAR] = (byte) frontSonar;
            data[FRONT_SONAR + 2] = (byte) rearSonar;
            data[WATCHDOG] = (byte) watchdogMs;
            data[WATCHDOG + 1] = (byte) (watchdogMs >> 8);
            line.send(Bytes.wire(0x20, data));
        }
    }

    @Override
    public void step(SteppedPeer line) {
        robot.step(0.001);
        if (sendsSips && line.millis() % cycleMs == 0) {
            sips++;
            speeds.add(robot.speed());
            if (!silent && (losesOneSipIn == 0 || sips % losesOneSipIn != 0)) {
                line.send(sip());
                if (laserOn) {
                    line.send(laser(900, 5000, 32_000));
                }
            }
        }
    }

    /** Its state now, in one packet. */
    byte[] sip() {
        int units =
                (int) Math.round((wholeDegrees ? Math.round(robot.heading()) : robot.heading()) / Scaling.DEG_PER_UNIT);
        double difference = Math.toRadians(robot.rate()) / 0.0056;
        SipBytes data = new SipBytes();
        for (int disc = frontSonar == 1 ? 0 : 8; disc < (rearSonar == 1 ? 16 : 8) && !lieNext && !sonarsOff; disc++) {
            data.sonar(disc, 5000);
        }
        byte[] bytes = data.pose(
                        (int) Math.round(robot.x() / mmPerCount), (int) Math.round(robot.y() / mmPerCount), units)
                .wheels((int) Math.round(robot.speed() - difference), (int) Math.round(robot.speed() + difference))
                .state(stallBits, (motors ? 1 : 0) | (sonarsOff ? 0 : 0x1E) | extraFlags)
                .bytes();
        if (lieNext) {
            lieNext = false;
            bytes[18] = 16;
        }
        return Bytes.wire(0x32, bytes);
    }

    /** A packet 0x60 with a whole scan (ARCOS sheet 11.8). */
    private static byte[] laser(int... ranges) {
        ByteBuffer data = ByteBuffer.allocate(11 + 2 * ranges.length).order(ByteOrder.LITTLE_ENDIAN);
        data.position(6);
        data.putShort((short) ranges.length).putShort((short) 0).put((byte) ranges.length);
        for (int range : ranges) {
            data.putShort((short) range);
        }
        return Bytes.wire(0x60, data.array());
    }

    /** The commands received, without pulses. */
    public List<String> orders() {
        return heard.stream().filter(command -> !command.equals("PULSE 0")).toList();
    }

    boolean heardLast(String... commands) {
        List<String> orders = orders();
        int from = Math.max(0, orders.size() - commands.length);
        return orders.subList(from, orders.size()).equals(List.of(commands));
    }

    /** How often the direction of the motion was reversed. */
    int turnsBack() {
        List<Double> moving =
                speeds.stream().filter(speed -> Math.abs(speed) > 1).toList();
        return (int) IntStream.range(1, moving.size())
                .filter(index -> moving.get(index) * moving.get(index - 1) < 0)
                .count();
    }

    private static String name(int number) {
        @Nullable String known = null;
        for (ArcosCommand command : ArcosCommand.values()) {
            known = command.number() == number ? command.name() : known;
        }
        return known == null ? "number " + number : known;
    }
}
