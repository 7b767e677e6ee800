package majicsim.pioneer;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.List;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;

/** A Pioneer in a room of 10 by 8 m around the origin, stepped by hand, with a client on a line. */
public final class Rig {
    public static final double STEP_SECONDS = 0.004;

    private static final String TEN_BY_EIGHT = """
            2D-Map
            LineMinPos: -5000 -4000
            LineMaxPos: 5000 4000
            NumLines: 4
            LINES
            -5000 -4000 5000 -4000
            5000 -4000 5000 4000
            5000 4000 -5000 4000
            -5000 4000 -5000 -4000
            DATA
            """;

    /** The usual model with all that its owner can have fitted, but for bumpers. */
    public static final String EQUIPPED = PioneerRobot.STANDARD_MODEL + "+gripper+gyro+charger+laser";

    public final World world = new World(tenByEight());
    public final PioneerRobot robot;
    public FakeLine line = new FakeLine();

    public Rig(Pose start, Noise noise, String model) {
        robot = new PioneerRobot(world, start, noise, model);
        robot.connected(line);
    }

    /** Exact, in the middle of the room, looking along x; no client has shaken hands. */
    public static Rig silent() {
        return new Rig(new Pose(0, 0, 0), Noise.exact(), PioneerRobot.STANDARD_MODEL);
    }

    /** As {@link #open()}, of another model. */
    public static Rig open(String model) {
        return new Rig(new Pose(0, 0, 0), Noise.exact(), model).shakeHands();
    }

    /** As {@link #silent()}, with an open session. */
    public static Rig open() {
        return silent().shakeHands();
    }

    /** As {@link #open()}, with motors on. */
    public static Rig ready() {
        return ready(PioneerRobot.STANDARD_MODEL);
    }

    /** As {@link #ready()}, of another model. */
    public static Rig ready(String model) {
        return open(model).command(4, 1);
    }

    public Rig shakeHands() {
        send("FA FB 03 00 00 00  FA FB 03 01 00 01  FA FB 03 02 00 02");
        return command(1, 1);
    }

    /** The client goes without CLOSE and another one comes. */
    public Rig reconnect() {
        robot.disconnected(line);
        line = new FakeLine();
        robot.connected(line);
        return this;
    }

    public Rig send(String hex) {
        robot.received(line, Hex.bytes(hex));
        return this;
    }

    /** Sends a command without any argument. */
    Rig command(int id) {
        return packet(id, new byte[0]);
    }

    /** Sends a command with a number, sign in the type byte. */
    public Rig command(int id, int value) {
        int magnitude = Math.abs(value);
        byte[] packet = new PacketWriter(id)
                .uint8(value < 0 ? 0x1B : 0x3B)
                .uint16(magnitude)
                .toBytes();
        robot.received(line, packet);
        return this;
    }

    /** Sends a command with these bytes behind its number. */
    public Rig packet(int id, String data) {
        return packet(id, Hex.bytes(data));
    }

    /** Sends a command with these bytes behind its number. */
    public Rig packet(int id, byte[] data) {
        PacketWriter packet = new PacketWriter(id);
        for (byte b : data) {
            packet.uint8(b);
        }
        robot.received(line, packet.toBytes());
        return this;
    }

    /** Lets lab time pass without a packet from the client. */
    public Rig step(double seconds) {
        for (long left = Math.round(seconds / STEP_SECONDS); left > 0; left--) {
            world.step(STEP_SECONDS);
            robot.step(STEP_SECONDS);
        }
        return this;
    }

    /** Lets lab time pass with a PULSE every 400 ms. */
    public Rig pulse(double seconds) {
        for (double left = seconds; left > 1e-9; left -= 0.4) {
            command(0, 0).step(Math.min(0.4, left));
        }
        return this;
    }

    /** Sends a command with a string. */
    public Rig text(int id, byte... bytes) {
        return packet(id, Hex.concat(new byte[] {0x2B, (byte) bytes.length}, bytes));
    }

    /** Lets time pass, and returns the packets of one type that came in it. */
    public List<byte[]> packets(int type, double seconds) {
        line.take();
        return pulse(seconds).line.take().stream()
                .filter(packet -> (packet[3] & 0xFF) == type)
                .toList();
    }

    /** Requests CONFIG. */
    public ConfigView config() {
        line.take();
        command(18, 1);
        return ConfigView.of(line.take().get(0));
    }

    /** The SIPs since messages were last taken. */
    public List<SipView> sips() {
        return line.take().stream().filter(SipView::isSip).map(SipView::new).toList();
    }

    /** Lets one SIP cycle pass and returns its SIP. */
    public SipView nextSip() {
        line.take();
        List<SipView> sips = step(0.1).sips();
        return sips.get(sips.size() - 1);
    }

    public Body body() {
        return robot.body();
    }

    public Pose pose() {
        return robot.body().pose();
    }

    private static Room tenByEight() {
        try {
            return Room.parse(new StringReader(TEN_BY_EIGHT), "test");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
