package majic.figures;

import java.io.IOException;
import java.util.OptionalLong;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.link.Links;
import majic.pioneer.MajicPioneer;
import majic.pioneer.TestPioneers;
import majic.pioneer.line.ArcosConnection;
import majic.stop.RecordingRelay;
import majic.stop.TimedBytes;

/** A simulated Pioneer whose link is recorded at both ends: where its desk writes and where the robot reads. */
final class RecordedPioneer {
    private static final int NO_SPEED = 0;

    private final TimedBytes written = new TimedBytes();
    private final RecordingRelay relay;
    private final MajicPioneer driver;

    private RecordedPioneer(RecordingRelay relay) {
        this.relay = relay;
        this.driver = TestPioneers.over(
                wait -> new ArcosConnection(
                        new TimedLink(Links.of(relay.address(), NO_SPEED, NO_SPEED), written), wait),
                BotEnvironment.plain());
    }

    /** Puts a recorder in front of the robot at a TCP port. */
    static RecordedPioneer at(int port) throws IOException {
        return new RecordedPioneer(RecordingRelay.tcp(port));
    }

    /** The robot as its desk uses it, not connected at first. */
    MajicBot driver() {
        return driver;
    }

    /** Returns how many bytes have arrived at the robot. */
    int arrivedBytes() {
        return relay.sent().length();
    }

    /** Returns when a packet arrived at the robot, after the first bytes, ns of the system's clock. */
    OptionalLong arrivalNanos(String packet, int from) {
        return relay.sent().nanosOf(packet, from);
    }

    /** Begins to time a command: what is found later was written after this call. */
    Sample begin(String packet) {
        return new Sample(this, packet, written.length(), arrivedBytes(), System.nanoTime());
    }

    /**
     * A command that was given.
     *
     * @param packet the robot gets it because of the command
     * @param written bytes at the beginning
     * @param arrived bytes at the beginning
     */
    record Sample(RecordedPioneer robot, String packet, int written, int arrived, long beganNanos) {
        /** Returns the time until the system of the desk had taken the packet, ns. */
        OptionalLong untilWritten() {
            return since(robot.written.nanosOf(packet, written));
        }

        /** Returns the time until the packet was read at the robot's end of the link, ns. */
        OptionalLong untilArrived() {
            return since(robot.arrivalNanos(packet, arrived));
        }

        private OptionalLong since(OptionalLong at) {
            return at.isPresent() ? OptionalLong.of(at.getAsLong() - beganNanos) : OptionalLong.empty();
        }
    }
}
