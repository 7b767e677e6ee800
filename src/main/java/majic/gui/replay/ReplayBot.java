package majic.gui.replay;

import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.LinkLost;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.recorder.RecordedRobot;
import majic.recorder.RobotTracks;
import majic.text.Texts;

/**
 * A recorded robot as its panel uses it: gives the parameters, the states and the connection of the time that is
 * replayed, has no link, and refuses every command.
 */
final class ReplayBot extends BotDriver {
    private static final Texts TEXTS = Texts.of(ReplayBot.class);

    /** Needed by a profile; no motion is ever accepted. */
    private static final Range ANY_SPEED = new Range(-1, 1);

    private final RobotTracks tracks;
    private volatile double seconds;

    ReplayBot(BotType type, RobotTracks tracks) {
        super(type, profile(tracks.robot()), BotEnvironment.plain());
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

    private static BotProfile profile(RecordedRobot robot) {
        return new BotProfile(robot.bodyMm(), ANY_SPEED, ANY_SPEED, 1, 1, 1, robot.estimates());
    }

    private static BotException refusal() {
        return new BotException(TEXTS.get("refused"));
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

    @Override
    protected void open() {}

    @Override
    protected void shut() {}

    @Override
    protected Value moveBy(double mm, Motion motion) {
        throw refusal();
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        throw refusal();
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        throw refusal();
    }

    @Override
    protected void halt() {}
}
