package majic.hemisson.panel;

import java.util.List;
import majic.bot.BotState;
import majic.bot.MajicBot.Connection;
import majic.hemisson.line.Identity;
import majic.hemisson.line.Leds;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.RunningMode;
import majic.hemisson.readings.Proximity;
import majic.text.ErrorWords;
import org.jspecify.annotations.Nullable;

/**
 * What the panel shows, taken at one moment. Immutable.
 *
 * @param line how well the robot is reached
 * @param seen its proximity readings; null before the first
 * @param light the light on its sensors; null while it is unknown or too old
 * @param wheels the values of its motors
 * @param state where it should be
 * @param leds its LEDs, as last confirmed
 * @param buzzing whether its buzzer is on, as last confirmed
 * @param identity the robot that answered at connecting
 * @param switches its switches as they are now; empty if unknown
 */
public record HemissonScene(
        Line line,
        @Nullable Proximity seen,
        @Nullable List<Integer> light,
        MotorValues wheels,
        BotState state,
        Leds leds,
        boolean buzzing,
        Identity identity,
        List<Integer> switches) {

    /**
     * How well the robot is reached.
     *
     * @param connection the state of the connection
     * @param quality how the answers came
     * @param missesAnswers whether one was missed recently
     * @param silentS time since the last answer, seconds
     * @param outOfControl whether it may move and cannot be reached
     */
    public record Line(
            Connection connection, LinkQuality quality, boolean missesAnswers, double silentS, boolean outOfControl) {}

    boolean isConnected() {
        return line.connection() == Connection.CONNECTED;
    }

    /** The name of the running mode, by the switches at connecting, in the language of the window. */
    String mode() {
        return ErrorWords.of(RunningMode.of(identity.switches()));
    }

    /** Whether it executes commands and nothing else; true if it did not report its switches. */
    boolean isRemoteControlled() {
        return identity.isRemoteControlled();
    }

    /** Whether the switches choose another mode for the next start than for this one. */
    boolean areSwitchesMoved() {
        return !identity.switches().isEmpty() && !switches.equals(identity.switches());
    }

    /** One proximity reading, that of the ground on the left corrected as far as the light is known (sheet 6). */
    int proximity(int sensor) {
        Proximity known = seen;
        List<Integer> shade = light;
        if (known == null) {
            return 0;
        }
        return sensor == Proximity.GROUND_LEFT && shade != null
                ? Proximity.correctedGroundLeft(
                        known.value(sensor), shade.get(Proximity.GROUND_RIGHT), shade.get(Proximity.GROUND_LEFT))
                : known.value(sensor);
    }
}
