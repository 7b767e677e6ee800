package majic.aibo.parameters;

import java.util.List;
import majic.aibo.sound.Volume;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** The speaker. The dog itself has no volume that could be set (URBI sheet 13). */
final class SoundParameters implements ParameterTheme<UrbiVersion> {
    private final AiboAccess access;
    private final Volume volume;

    SoundParameters(AiboAccess access, Volume volume) {
        this.access = access;
        this.volume = volume;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        table.add(Parameter.onOff("beep", "on beeps once"), () -> Value.onOff(false))
                .writes(values -> beep(values.get(0).isYes()));
        table.add(
                        Parameter.number("volume", Unit.PERCENT, "how loud play is with files of this computer")
                                .within(0, Volume.FULL_PERCENT),
                        () -> Value.of(volume.percent(), Unit.PERCENT))
                .kept()
                .writes(values -> volume.set(values.get(0).number()));
        table.add(
                Parameter.yesNo("playing", "whether the dog plays a sound"),
                access.asked("speaker.playing", amount -> Value.yesNo(amount > 0)));
        table.add(
                Parameter.number("playingLeft", Unit.MS, "how much of the sound is still to come"),
                access.asked("speaker.remain", amount -> Value.of(amount, Unit.MS)));
    }

    private void beep(boolean on) {
        if (on) {
            access.send(List.of("speaker.play(\"beep.wav\")"));
        }
    }
}
