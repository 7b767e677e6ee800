package majic.hemisson;

import java.util.List;
import majic.bot.BotState;
import org.jspecify.annotations.Nullable;

/**
 * What the panel shows, taken at one moment. Immutable.
 *
 * @param connected whether the robot can be commanded
 * @param seen its proximity readings; null before the first
 * @param wheels what its motors are told
 * @param state where it should be
 * @param leds its lamps
 * @param buzzing whether its buzzer is on
 * @param switches its switches as they were at connecting; empty if not told
 * @param quality how well the line works
 */
record HemissonView(
        boolean connected,
        @Nullable Proximity seen,
        Wheels wheels,
        BotState state,
        Leds leds,
        boolean buzzing,
        List<Integer> switches,
        LinkQuality quality) {

    static HemissonView of(MajicHemisson bot) {
        return new HemissonView(
                bot.isConnected(),
                bot.overseer().seen(),
                bot.overseer().track().wheels(),
                bot.state(),
                bot.lamps().leds(),
                bot.lamps().isBuzzing(),
                bot.identity().switches(),
                bot.quality());
    }
}
