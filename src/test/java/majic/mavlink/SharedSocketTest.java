package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.ConnectFailed;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Several vehicles that send to one UDP port, on the clock of the system, as a radio or a proxy forwards them. */
class SharedSocketTest {
    private static final int VEHICLES = 20;

    @AutoClose
    private final Vehicles vehicles = new Vehicles(freePort());

    /** The vehicles, all behind one socket. */
    private static final class Vehicles implements AutoCloseable {
        private final DatagramSocket socket;
        private final int port;
        private final List<ScriptedRover> rovers = new ArrayList<>();
        private final Thread thread = new Thread(this::run, "vehicles");
        private volatile boolean over;

        Vehicles(int port) {
            this.port = port;
            try {
                socket = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
                socket.setSoTimeout(1);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        void begin(int count) {
            for (int system = 1; system <= count; system++) {
                ScriptedRover rover = new ScriptedRover(this::send);
                rover.system = system;
                rover.armed = true;
                rover.mode = ScriptedRover.GUIDED;
                rovers.add(rover);
            }
            thread.setDaemon(true);
            thread.start();
        }

        private void send(byte[] frame) {
            try {
                socket.send(new DatagramPacket(frame, frame.length, InetAddress.getLoopbackAddress(), port));
            } catch (IOException e) {
                over = true;
            }
        }

        private void run() {
            long steppedNanos = System.nanoTime();
            byte[] buffer = new byte[2048];
            while (!over) {
                try {
                    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
                    socket.receive(packet);
                    byte[] bytes = Arrays.copyOf(buffer, packet.getLength());
                    rovers.forEach(rover -> rover.receive(bytes));
                } catch (SocketTimeoutException e) {
                    // Nothing has come within a millisecond.
                } catch (IOException e) {
                    return;
                }
                for (; System.nanoTime() - steppedNanos > 1_000_000; steppedNanos += 1_000_000) {
                    rovers.forEach(ScriptedRover::step);
                }
            }
        }

        @Override
        public void close() {
            over = true;
            socket.close();
        }
    }

    private static int freePort() {
        try (DatagramSocket free = new DatagramSocket(0)) {
            return free.getLocalPort();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private MajicMavlink bot(String options) {
        return new MajicMavlink(BotAddress.parse("mavlink:udp://:" + vehicles.port + options), BotEnvironment.plain());
    }

    @Test
    void aStopReachesTwentyVehiclesOnOneSocket() {
        vehicles.begin(VEHICLES);
        List<MajicMavlink> bots = IntStream.rangeClosed(1, VEHICLES)
                .mapToObj(system -> bot("?system=" + system))
                .toList();
        try {
            CompletableFuture.allOf(bots.stream()
                            .map(bot -> CompletableFuture.runAsync(bot::connect, body -> new Thread(body).start()))
                            .toArray(CompletableFuture[]::new))
                    .join();

            CompletableFuture.allOf(bots.stream()
                            .map(bot -> CompletableFuture.runAsync(bot::stop, body -> new Thread(body).start()))
                            .toArray(CompletableFuture[]::new))
                    .join();

            assertThat(vehicles.rovers).allMatch(rover -> rover.mode == ScriptedRover.HOLD);
        } finally {
            bots.forEach(MajicMavlink::close);
        }
    }

    @Test
    void severalVehiclesWithoutASystemAreListed() {
        vehicles.begin(2);

        try (MajicMavlink bot = bot("")) {
            assertThatThrownBy(bot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining("several vehicles send to UDP port " + vehicles.port)
                    .hasMessageContaining("1 (rover), 2 (rover); name one of them, as ?system=1");
        }
    }

    @Test
    void theVehiclesBehindAnAddressAreFound() {
        vehicles.begin(2);

        assertThat(new MavlinkType()
                        .robotsAt(BotAddress.parse("mavlink:udp://:" + vehicles.port + "/"), BotEnvironment.plain()))
                .containsExactly(
                        Map.entry("mavlink:udp://:" + vehicles.port + "?system=1", "rover"),
                        Map.entry("mavlink:udp://:" + vehicles.port + "?system=2", "rover"));
    }

    @Test
    void closingOneRobotLeavesTheSocketToTheOthers() {
        vehicles.begin(2);
        MajicMavlink one = bot("?system=1");
        try (MajicMavlink two = bot("?system=2")) {
            one.connect();
            two.connect();

            one.close();
            two.stop();

            assertThat(two.isConnected()).isTrue();
            assertThat(vehicles.rovers.get(1).mode).isEqualTo(ScriptedRover.HOLD);
        }
    }

    @Test
    void aStopGoesToTheAutopilotThoughACameraOfItsVehicleSendsFromAnotherAddress() {
        vehicles.begin(1);
        try (Vehicles cameras = new Vehicles(vehicles.port);
                MajicMavlink bot = bot("")) {
            cameras.begin(1);
            cameras.rovers.get(0).component = 100;
            bot.connect();

            bot.stop();

            assertThat(vehicles.rovers.get(0).mode).isEqualTo(ScriptedRover.HOLD);
            assertThat(cameras.rovers.get(0).mode).isEqualTo(ScriptedRover.GUIDED);
        }
    }

    @Test
    void aSecondVehicleWithTheSameNumberIsSaidAndIgnored() {
        vehicles.begin(1);
        CompletableFuture<String> said = new CompletableFuture<>();
        try (Vehicles others = new Vehicles(vehicles.port);
                MajicMavlink bot = bot("")) {
            bot.addListener(new BotListener() {
                @Override
                public void notice(MajicBot robot, String message) {
                    if (message.contains("second autopilot")) {
                        said.complete(message);
                    }
                }
            });
            bot.connect();
            others.begin(1);

            assertThat(said.orTimeout(10, TimeUnit.SECONDS).join())
                    .contains("with the number 1 sends from 127.0.0.1 port " + others.socket.getLocalPort());
            bot.stop();

            assertThat(vehicles.rovers.get(0).mode).isEqualTo(ScriptedRover.HOLD);
            assertThat(others.rovers.get(0).mode).isEqualTo(ScriptedRover.GUIDED);
        }
    }
}
