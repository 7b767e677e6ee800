package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Optional;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import org.jspecify.annotations.Nullable;

/** What the vendor's client does in a session, by itself or under its Java wrapper or ROS (ARCOS sheet 4 and 13.2). */
final class AriaClient implements VendorClient {
    private static final int OPEN = 1;
    private static final int CLOSE = 2;
    private static final int ENABLE = 4;
    private static final int MOVE = 8;
    private static final int VEL = 11;
    private static final int HEAD = 12;
    private static final int CONFIG = 18;
    private static final int RVEL = 21;
    private static final int HOSTBAUD = 50;
    private static final int BATTERYINFO = 62;
    private static final int STANDING = 0x32;
    private static final int CONFIG_TYPE = 0x20;
    private static final int MOST_TRIES = 50;
    private static final int[] ALL_SPEEDS = {9600, 38_400, 115_200, 19_200, 57_600};

    private final StandClient client;
    private final boolean serial;
    private int silences;

    AriaClient(StandClient client, boolean serial) {
        this.client = client;
        this.serial = serial;
    }

    @Override
    public void connect() throws IOException {
        if (serial) {
            client.write("57 4D 53 32 0D");
        }
        client.during(0.1);
        synchronise();
        client.during(0.1);
        client.command(OPEN, 1);
        client.command(CONFIG, 1);
        client.await(CONFIG_TYPE, 1);
        if (serial) {
            goTo38400();
        }
        client.command(BATTERYINFO, 1);
        assertThat(client.sip().hasMotors()).isFalse();
        client.write("FA FB 06 06 3B B8 0B BE 46 FA FB 06 05 3B 2C 01 31 3C FA FB 06 05 1B 2C 01 31 1C"
                + "FA FB 06 0A 3B 96 00 A0 3B FA FB 06 17 3B 64 00 7B 3B FA FB 06 17 1B 64 00 7B 1B FA FB 03 00 00 00");
    }

    @Override
    public void driveAndRead() throws IOException {
        client.command(ENABLE, 1);
        client.command(VEL, 250);
        client.during(0.5);
        client.command(VEL, 250);
        assertThat(client.sipAfter(0.5).left()).isEqualTo(250);
        client.write(Hex.concat(StandClient.packet(VEL, 0), StandClient.packet(RVEL, 0)));
        client.command(MOVE, -150);
        double wanted = client.sip().headingDeg() + 20;
        for (int i = 0; i < 20; i++) {
            client.command(HEAD, (int) Math.round(wanted));
            client.during(0.1);
        }
        SipView end = client.sip();
        assertThat(Math.IEEEremainder(end.headingDeg() - wanted, 360)).isCloseTo(0, within(1.0));
        assertThat(end.sonar()).isNotEmpty();
    }

    @Override
    public void disconnect() throws IOException {
        client.write(Hex.concat(StandClient.packet(VEL, 0), StandClient.packet(RVEL, 0)));
        client.command(ENABLE, 0);
        client.during(0.1);
        client.command(CLOSE, 1);
        if (serial) {
            client.during(0.1);
            assertThat(client.during(0.9)).isEmpty();
            client.vanish();
        } else {
            client.awaitEnd();
        }
    }

    /** Stops the robot before it ends; a moving robot would move on at the next client's first packet. */
    @Override
    public void vanish() throws IOException {
        client.write(Hex.concat(StandClient.packet(VEL, 0), StandClient.packet(RVEL, 0)));
        client.during(1.5);
        client.vanish();
    }

    private void synchronise() throws IOException {
        int state = 0;
        for (int tries = 0; state < 3; tries++) {
            assertThat(tries).as("tries to shake hands").isLessThan(MOST_TRIES);
            client.command(state);
            state = stateAfter(state, client.next(1).orElse(null));
            client.during(0.07);
        }
    }

    private int stateAfter(int state, @Nullable Packet answer) throws IOException {
        if (answer == null) {
            silent();
            return 0;
        }
        if (answer.id() == STANDING) {
            closeWhatIsOpen();
            return 0;
        }
        return answer.id() == state ? state + 1 : 0;
    }

    private void closeWhatIsOpen() throws IOException {
        client.command(CLOSE, 1);
        for (Optional<Packet> more = client.next(0.2); more.isPresent(); more = client.next(0.2)) {
            if (more.get().id() == STANDING) {
                client.command(CLOSE, 1);
            }
        }
    }

    /** After two silent seconds it closes at all speeds what may be open; after four it tries to open. */
    private void silent() throws IOException {
        silences++;
        if (silences == 2 && serial) {
            for (int speed : ALL_SPEEDS) {
                client.wire().baud(speed);
                client.command(CLOSE, 1);
                client.during(0.004);
            }
            client.wire().baud(9600);
        }
        if (silences > 3) {
            client.command(OPEN, 1);
        }
    }

    private void goTo38400() throws IOException {
        client.command(HOSTBAUD, 2);
        client.during(0.012);
        client.wire().baud(38_400);
        client.during(0.012);
        client.command(0);
        assertThat(client.next(0.9)).isPresent();
    }
}
