package majic.pioneer.panel;

import majic.bot.MajicBot;
import majic.bot.Range;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Model;
import majic.pioneer.state.PioneerState;

/**
 * What is shown of a Pioneer, taken at one moment. Immutable.
 *
 * @param model its hull and where its sonars sit
 * @param state what it last said
 * @param bumpers the segments it really has
 * @param connection how the link stands
 * @param silenceMs since its last word
 * @param reception how well its packets arrived
 * @param speedLimits mm/s, both signs
 * @param turnLimits deg/s, both signs
 */
public record PioneerScene(
        Model model,
        PioneerState state,
        Bumpers bumpers,
        MajicBot.Connection connection,
        double silenceMs,
        PacketCounts reception,
        Range speedLimits,
        Range turnLimits) {

    boolean isConnected() {
        return connection == MajicBot.Connection.CONNECTED;
    }
}
