package majic.hemisson.panel;

import java.util.List;
import majic.bot.BotState;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.hemisson.line.Identity;
import majic.hemisson.line.Leds;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.MotorValues;
import majic.hemisson.motion.SpeedTable;
import majic.hemisson.panel.HemissonScene.Line;
import majic.hemisson.readings.Proximity;
import org.jspecify.annotations.Nullable;

/** Moments of a Hemisson for tests of what is shown of them. */
final class Scenes {
    static final Line WELL = new Line(Connection.CONNECTED, LinkQuality.NONE, false, 0, false);
    static final Line LOST = new Line(Connection.LOST, LinkQuality.NONE, false, 0, false);
    static final Line LOST_MOVING = new Line(Connection.LOST, LinkQuality.NONE, true, 0, true);
    static final List<Integer> REMOTE = List.of(1, 1, 1, 1);
    static final List<Integer> DANCE = List.of(1, 0, 1, 1);

    private Scenes() {}

    static HemissonScene standing(Line line) {
        return of(line, MotorValues.STILL, REMOTE, REMOTE);
    }

    static HemissonScene driving(MotorValues wheels) {
        return of(WELL, wheels, REMOTE, REMOTE);
    }

    static HemissonScene dancing() {
        return of(WELL, new MotorValues(9, 5), DANCE, DANCE);
    }

    /** With switches as they were at its start and as they are. */
    static HemissonScene withSwitches(List<Integer> atStart, List<Integer> now) {
        return of(WELL, MotorValues.STILL, atStart, now);
    }

    static HemissonScene seeing(@Nullable Proximity seen, @Nullable List<Integer> light) {
        return new HemissonScene(
                WELL, seen, light, MotorValues.STILL, BotState.UNKNOWN, Leds.OFF, false, identity(REMOTE), REMOTE);
    }

    private static HemissonScene of(Line line, MotorValues wheels, List<Integer> atStart, List<Integer> now) {
        BotState state = new BotState(
                Pose.START,
                SpeedTable.USUAL.speedMmPerSec(wheels),
                SpeedTable.USUAL.turnDegPerSec(wheels),
                !wheels.isStill(),
                0);
        return new HemissonScene(line, null, null, wheels, state, Leds.OFF, false, identity(atStart), now);
    }

    private static Identity identity(List<Integer> switches) {
        return new Identity("HemiOS_v_1.50", switches, true);
    }
}
