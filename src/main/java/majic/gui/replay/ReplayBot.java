package majic.gui.replay;

import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.LinkLost;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.MotionlessBot;
import majic.environment.BotEnvironment;
import majic.recorder.RobotTracks;
import majic.text.Texts;

/**
 * A recorded robot as its panel uses it: gives the parameters, the states and the connection of the time that is
 * replayed, has no link, and refuses every command.
 */
final class ReplayBot extends MotionlessBot {
    private static final Texts TEXTS = Texts.of(ReplayBot.class);

    private final RobotTracks tracks;
    private volatile double seconds;

    ReplayBot(BotType type, RobotTracks tracks) {
        super(type, tracks.robot().bodyMm(), tracks.robot().estimates(), BotEnvironment.plain(), TEXTS.get("refused"));
        this.tracks = tracks;
        for (Parameter parameter : tracks.parameters()) {
            table().add(parameter, () -> tracks.value(parameter, seconds))
                    .kept()
                    .writes(values -> {
                        throw refusal();
                    });
        }
        table().add(
                        Parameter.number("age", Unit.MS, TEXTS.get("age")),
                        () -> Value.of(Math.round(ageS() * 1000), Unit.MS))
                .kept();
    }

    private double ageS() {
        return seconds - tracks.lastChangeS(seconds);
    }

    /** Takes the state of a time of the recording. */
    void show(double atS) {
        seconds = atS;
        boolean wasConnected = tracks.status("connection", atS).equals("connected");
        if (wasConnected && !isConnected()) {
            connect();
        } else if (!wasConnected && isConnected()) {
            lost(new LinkLost(TEXTS.get("connectionLost")));
        }
        long reportedNanos = time().nanos() - (long) (ageS() * 1e9);
        publish(new BotState(
                tracks.pose(atS),
                number("speed"),
                number("turnRate"),
                tracks.number("moving", atS).orElse(0.0) > 0,
                reportedNanos));
    }

    private double number(String parameter) {
        return tracks.number(parameter, seconds).orElse(0.0);
    }
}
