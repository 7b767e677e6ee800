package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotAddress;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.Links;
import majic.link.PseudoTerminal;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.SipBytes;
import majic.simulation.TransitCheck;
import majicsim.net.LineCount;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The driver on a real serial port, in stepped time, with a robot at the other end that has one speed at a time. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "the port's speed is read as Linux keeps it")
class SerialSpeedTest {
    private static final int PULSE = 0;
    private static final int CLOSE = 2;
    private static final int HOSTBAUD = 50;
    private static final int B9600 = 13;
    private static final int B38400 = 15;
    private static final long CYCLE_NANOS = 50_000_000;

    private final PseudoTerminal plug = new PseudoTerminal();
    private final List<Integer> heard = new CopyOnWriteArrayList<>();
    private final AtomicLong consumed = new AtomicLong();
    private final AtomicLong written = new AtomicLong();
    private final TestClock clock =
            new TestClock(this::step, new TransitCheck(Links::traffic, this::lines, Set.of(plug.name())));
    private final MajicPioneer bot = new MajicPioneer(
            new BotAddress("pioneer", plug.name()), new BotEnvironment(clock.time(), Settings.inMemory()));
    private volatile int speed = B9600;
    private volatile boolean changesSpeed = true;
    private volatile boolean open;
    private volatile boolean oneMoreIsOnItsWay;
    private volatile boolean portIsOpen = true;

    private void connect() {
        Thread robot = new Thread(this::converse, "robot on a port");
        robot.setDaemon(true);
        robot.start();
        bot.connect();
    }

    @AfterEach
    void unplug() {
        bot.close();
        clock.close();
        plug.close();
    }

    @Test
    void theSpeedIsRaisedIfTheRobotRequestsIt() {
        connect();

        assertThat(heard).contains(HOSTBAUD);
        assertThat(plug.speedCode()).isEqualTo(B38400);
        assertThat(bot.get("motors")).hasToString("no");
    }

    @Test
    void aRobotThatDoesNotFollowKeepsTheFormerSpeed() {
        changesSpeed = false;
        connect();

        assertThat(heard).contains(HOSTBAUD);
        assertThat(plug.speedCode()).isEqualTo(B9600);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aSipThatWasOnItsWayBeforeTheChangeProvesNothing() {
        changesSpeed = false;
        oneMoreIsOnItsWay = true;
        connect();

        assertThat(oneMoreIsOnItsWay).isFalse();
        assertThat(plug.speedCode()).isEqualTo(B9600);
    }

    @Test
    void aRobotThatASessionBeforeHasLeftFastIsFound() {
        speed = B38400;
        connect();

        assertThat(plug.speedCode()).isEqualTo(B38400);
        assertThat(heard).doesNotContain(HOSTBAUD);
    }

    @Test
    void closingRestoresThePowerUpSpeed() {
        connect();

        bot.close();
        awaitGoodBye();

        assertThat(heard).endsWith(PULSE, CLOSE).containsSubsequence(HOSTBAUD, PULSE, CLOSE);
        assertThat(speed).isEqualTo(B9600);
        assertThat(plug.speedCode()).isEqualTo(B9600);
    }

    @Test
    void aRobotThatStaysAtTheHighSpeedReceivesTheClose() {
        connect();
        changesSpeed = false;

        bot.close();
        awaitGoodBye();

        assertThat(heard).endsWith(CLOSE);
        assertThat(speed).isEqualTo(B38400);
    }

    /** The last bytes may still be on the line. */
    private void awaitGoodBye() {
        while (heard.get(heard.size() - 1) != CLOSE) {
            Thread.onSpinWait();
        }
    }

    private void converse() {
        FrameDecoder decoder = new FrameDecoder();
        try {
            while (true) {
                byte[] bytes = plug.read().getBytes(StandardCharsets.ISO_8859_1);
                if (plug.speedCode() == speed) {
                    decoder.feed(bytes, bytes.length, this::received);
                }
                consumed.addAndGet(bytes.length);
            }
        } catch (IOException e) {
            open = false;
            portIsOpen = false;
        }
    }

    private List<LineCount> lines() {
        return List.of(new LineCount(plug.name(), plug.name(), consumed.get(), written.get(), portIsOpen, false));
    }

    private void step(long nanos) {
        if (nanos % CYCLE_NANOS == 0) {
            sendSip();
        }
    }

    private void received(Packet packet) {
        if (!open && packet.type() < 2) {
            write(Bytes.wire(packet.type(), new byte[0]));
        } else if (!open) {
            open = true;
            write(Bytes.of(Bytes.NAMES));
        } else {
            obey(packet);
        }
    }

    private void obey(Packet packet) {
        heard.add(packet.type());
        if (packet.type() == 18) {
            write(Bytes.of(Bytes.CONFIG));
        } else if (packet.type() == HOSTBAUD && changesSpeed) {
            speed = packet.data()[1] == 2 ? B38400 : B9600;
        }
    }

    private void sendSip() {
        if (open && heard.contains(1)) {
            write(Bytes.wire(0x32, new SipBytes().state(0, 0x1E).bytes()));
        }
    }

    /** Sends noise if its speed is not the computer's. */
    private synchronized void write(byte[] bytes) {
        boolean understood = plug.speedCode() == speed;
        byte[] arriving = understood || oneMoreIsOnItsWay ? bytes : new byte[] {(byte) 0xE6, 0x19, (byte) 0x80};
        oneMoreIsOnItsWay &= understood;
        written.addAndGet(arriving.length);
        plug.write(new String(arriving, StandardCharsets.ISO_8859_1));
    }
}
