package majic.hemisson;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.hemisson.line.CurrentSession;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.Question;
import majic.hemisson.motion.RobotMonitor;
import majic.hemisson.panel.HemissonScene;
import majic.hemisson.parameters.LedsAndBuzzer;
import majic.hemisson.readings.PolledAnswers;
import org.jspecify.annotations.Nullable;

/** Collects what the panel shows from the state of the driver; sends nothing. Thread-safe. */
final class HemissonScenes {
    /** A light reading older than this is not shown. */
    private static final double FRESH_S = 3;

    /** How long a missed answer is shown. */
    private static final double RECENT_S = 5;

    private final MajicBot bot;
    private final CurrentSession sessions;
    private final RobotMonitor monitor;
    private final LedsAndBuzzer leds;

    HemissonScenes(MajicBot bot, CurrentSession sessions, RobotMonitor monitor, LedsAndBuzzer leds) {
        this.bot = bot;
        this.sessions = sessions;
        this.monitor = monitor;
        this.leds = leds;
    }

    /** Collects what the panel shows now. */
    HemissonScene now() {
        return new HemissonScene(
                line(),
                monitor.proximity(),
                freshLight(),
                monitor.pose().wheels(),
                bot.state(),
                leds.leds(),
                leds.isBuzzing(),
                monitor.identity(),
                switches());
    }

    private HemissonScene.Line line() {
        LinkQuality quality = sessions.quality();
        return new HemissonScene.Line(
                bot.connection(),
                quality,
                quality.hasMissedSince(bot.time().nanos() - (long) (RECENT_S * 1e9)),
                bot.isConnected() ? sessions.silentSeconds() : 0,
                isOutOfControl());
    }

    private boolean isOutOfControl() {
        HemissonSession open = sessions.current();
        return open != null
                && (open.conversation().isUnreached()
                        || (bot.connection() == Connection.LOST
                                && open.conversation().mayMove()));
    }

    /** The light on the eight sensors, 0 bright to 255 dark; null before the first reading and when it is old. */
    private @Nullable List<Integer> freshLight() {
        PolledAnswers.Answer answer = monitor.polled().answer(Question.LIGHT);
        return answer != null && bot.time().nanos() - answer.nanos() < FRESH_S * 1e9
                ? answer.reply().numbers()
                : null;
    }

    /** The switches as they are now; those of the time of connecting before the first reading. */
    private List<Integer> switches() {
        PolledAnswers.Answer answer = monitor.polled().answer(Question.SWITCHES);
        return answer == null ? monitor.identity().switches() : answer.reply().numbers();
    }
}
