package majic.pioneer.panel;

import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Range;
import majic.bot.RangeScan;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Model;
import majic.pioneer.state.PioneerState;

/**
 * A snapshot of what the panel of a Pioneer shows. Immutable.
 *
 * @param model its hull and its sonars
 * @param state the last state reported
 * @param laser its last scan; empty if it has none, or nothing asks for scans at the moment
 * @param bumpers the segments that it has
 * @param connection state of the connection
 * @param silenceMs since the last report
 * @param packetRate state packets a second; 0 before the second one
 * @param packets counts of packets and damaged bytes
 * @param speedLimits mm/s, both signs
 * @param turnLimits deg/s, both signs
 */
public record PioneerScene(
        Model model,
        PioneerState state,
        Optional<RangeScan> laser,
        Bumpers bumpers,
        MajicBot.Connection connection,
        double silenceMs,
        double packetRate,
        PacketCounts packets,
        Range speedLimits,
        Range turnLimits) {

    /**
     * Returns this scene as the last one of an earlier connection.
     *
     * @param now the state of the new connection, which has reported nothing yet
     */
    PioneerScene before(MajicBot.Connection now) {
        return new PioneerScene(
                model,
                state,
                Optional.empty(),
                bumpers,
                now == MajicBot.Connection.CONNECTED ? MajicBot.Connection.CONNECTING : now,
                silenceMs,
                packetRate,
                packets,
                speedLimits,
                turnLimits);
    }

    boolean isConnected() {
        return connection == MajicBot.Connection.CONNECTED;
    }
}
