package majic.hemisson;

import majic.bot.Pose;

/** Where the robot should be by what its wheels were told, and what it publishes of that. Thread-safe. */
final class DeadReckoning {
    private final MajicHemisson bot;
    private volatile Track track;

    /** Standing at its start. */
    DeadReckoning(MajicHemisson bot, SpeedTable table) {
        this.bot = bot;
        this.track = Track.standing(Pose.START, bot.nanos(), table);
    }

    Track track() {
        return track;
    }

    /** Begins anew at the start, for a new connection. */
    void begin() {
        track = Track.standing(Pose.START, bot.nanos(), track.table());
    }

    /** Goes on with another calibration. */
    void use(SpeedTable table) {
        long now = bot.nanos();
        track = new Track(track.at(now), now, track.wheels(), table);
    }

    /** Takes note that the wheels were set, by whomever, from a moment on. */
    void follow(Wheels wheels, long nanos) {
        track = track.then(wheels, nanos);
        publish();
    }

    /** Tells everybody where it should be now. */
    void publish() {
        boolean moving = !track.wheels().isStill() || bot.identity().mayMoveUntold();
        bot.tell(track.state(bot.nanos(), moving));
    }
}
