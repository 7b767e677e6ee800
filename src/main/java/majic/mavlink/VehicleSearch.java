package majic.mavlink;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import majic.bot.ConnectFailed;
import majic.mavlink.frame.MavlinkFrame;
import majic.mavlink.line.FrameListener;
import majic.mavlink.line.VehicleEndpoint;
import majic.mavlink.line.VehicleLine;
import majic.mavlink.line.VehicleLines;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.session.VehicleClass;
import majic.time.Signal;
import majic.time.TimeSource;

/** Finds the vehicles behind one address, by their heartbeats. */
final class VehicleSearch {
    private static final int OPEN_MS = 3000;
    private static final double LISTEN_S = 2.5;

    private VehicleSearch() {}

    /**
     * Listens for some seconds.
     *
     * @return the kinds of the vehicles by their systems
     * @throws ConnectFailed if the connection cannot be opened
     */
    static Map<Integer, String> search(VehicleEndpoint endpoint, TimeSource time) {
        Signal never = time.signal();
        try (VehicleLine line = VehicleLines.join(endpoint, OPEN_MS, time, new Ignored())) {
            line.sendToAll(MavlinkRequests.heartbeat());
            never.await(() -> false, LISTEN_S);
            Map<Integer, String> found = new LinkedHashMap<>();
            line.autopilots()
                    .forEach((system, heartbeat) ->
                            found.put(system, VehicleClass.of(heartbeat).title()));
            return found;
        } catch (IOException e) {
            throw ConnectFailed.of(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Map.of();
        }
    }

    /** The connection keeps what is needed. */
    private static final class Ignored implements FrameListener {
        @Override
        public int system() {
            return 0;
        }

        @Override
        public void received(MavlinkFrame frame) {
            // The connection has the heartbeats.
        }

        @Override
        public void ignored(int system, String address) {
            // Only the number is listed.
        }

        @Override
        public void ended(IOException cause) {
            // What was heard until then is listed.
        }
    }
}
