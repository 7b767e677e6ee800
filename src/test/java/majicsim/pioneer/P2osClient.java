package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Optional;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketWriter;

/**
 * What Player's driver does in a session, and ROS's, which comes from it (ARCOS sheet 13.3): bare commands, one for
 * each SIP, wheels by raw bytes. {@code ros} drives by VEL and RVEL.
 */
final class P2osClient implements VendorClient {
    private static final int OPEN = 1;
    private static final int CLOSE = 2;
    private static final int ENABLE = 4;
    private static final int VEL = 11;
    private static final int RVEL = 21;
    private static final int SONAR = 28;
    private static final int STOP = 29;
    private static final byte[] RIGHT_MINUS_100_LEFT_200 =
            new PacketWriter(32).uint8(0x3B).uint8(-5).uint8(10).toBytes();
    private static final double CYCLE_SECONDS = 0.2;
    private static final int[] SPEEDS = {9600, 38_400, 19_200, 115_200, 57_600};

    private final StandClient client;
    private final boolean serial;
    private final boolean ros;
    private boolean sentClose;
    private int speed;
    private int attemptsLeft = 3;

    P2osClient(StandClient client, boolean serial, boolean ros) {
        this.client = client;
        this.serial = serial;
        this.ros = ros;
    }

    @Override
    public void connect() throws IOException {
        for (int state = 0; state < 3; client.during(0)) {
            client.command(state);
            Optional<Packet> answer = client.next(2 * CYCLE_SECONDS);
            state = answer.isPresent() ? stateAfter(state, answer.get()) : stateAfterSilence(state);
        }
        client.command(OPEN);
        client.during(CYCLE_SECONDS);
        client.command(0);
        client.during(CYCLE_SECONDS);
        onNextSip(SONAR, 0);
        assertThat(client.sipAfter(0.2).sonar()).isEmpty();
    }

    @Override
    public void driveAndRead() throws IOException {
        onNextSip(SONAR, 1);
        onNextSip(ENABLE, 0);
        client.sip();
        client.write("FA FB 04 07 3B 07 3B");
        onNextSip(ENABLE, 1);
        if (ros) {
            onNextSip(VEL, 50);
            onNextSip(RVEL, -48);
        } else {
            client.sip();
            client.write(RIGHT_MINUS_100_LEFT_200);
        }
        SipView driving = client.sipAfter(1.5);
        assertThat(driving.left() + driving.right()).isCloseTo(100, within(4));
        assertThat(driving.left() - driving.right()).isCloseTo(300, within(6));
        assertThat(driving.sonar()).isNotEmpty();
    }

    @Override
    public void disconnect() throws IOException {
        client.command(STOP);
        client.during(CYCLE_SECONDS);
        client.command(CLOSE);
        if (!serial) {
            client.awaitEnd();
        } else {
            client.during(CYCLE_SECONDS);
            client.vanish();
        }
    }

    @Override
    public void vanish() throws IOException {
        client.command(STOP);
        client.during(1);
        client.vanish();
    }

    private void onNextSip(int command, int value) throws IOException {
        client.sip();
        client.command(command, value);
    }

    private int stateAfter(int state, Packet answer) throws IOException {
        if (answer.id() <= 2) {
            return answer.id() + 1;
        }
        if (!sentClose) {
            sentClose = true;
            client.command(CLOSE);
            client.during(2 * CYCLE_SECONDS);
            return 0;
        }
        return state;
    }

    /** At the wrong end of its list of speeds it gives up, and its user starts it again. */
    private int stateAfterSilence(int state) {
        if (--attemptsLeft < 0 && serial) {
            speed++;
            assertThat(speed).as("speeds tried").isLessThan(2 * SPEEDS.length);
            client.wire().baud(SPEEDS[speed % SPEEDS.length]);
            attemptsLeft = 3;
        }
        return state;
    }
}
