package majic.aibo.session;

import java.util.List;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.PingProbe;
import majic.aibo.urbi.Tags;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/** Detects a dog that no longer reports or no longer receives. Used by the robot's timer thread. */
final class ConnectionMonitor {
    private static final double LOST_S = 4;

    private final AiboConnections connections;
    private final MessageRouter router;
    private final List<PingProbe> probes;
    private boolean reported;

    /** Begins to watch links that are open. */
    ConnectionMonitor(AiboConnections connections, MessageRouter router, Tags tags, RobotWait waiting, DogClock clock) {
        this.connections = connections;
        this.router = router;
        this.probes = List.of(
                new PingProbe(connections.motion(), tags, waiting, clock),
                new PingProbe(connections.stop(), tags, waiting, clock));
    }

    /** Breaks the connection if it does not reach the dog any more. */
    void tick() {
        if (router.silenceS() > LOST_S) {
            connections.broken(connections.sensors(), "no message from the dog for " + (int) LOST_S + " s");
        }
        for (PingProbe probe : probes) {
            if (!probe.check()) {
                connections.broken(probe.connection(), PingProbe.silence());
            }
        }
    }

    /** Why the dog must not move, if a silence has begun that was not reported yet; otherwise null. */
    @Nullable
    String fallsSilent() {
        String silence = router.silence();
        boolean report = !reported;
        reported = silence != null;
        return report ? silence : null;
    }
}
