package majic.pioneer.parameters;

import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Equipment;
import majic.time.TimeSource;

/** The buzzer. */
final class BuzzerParameters implements ParameterTheme<Equipment> {
    /** Pairs of duration in 20 ms and MIDI note; 0 is silence. Three rising tones, one second (ARCOS sheet 6.1). */
    private static final byte[] TONES = {10, 72, 5, 0, 10, 76, 5, 0, 20, 79};

    private static final byte[] SILENCE = {1, 0};
    private static final double TONES_S = 1;

    private final PioneerAccess access;
    private final TimeSource time;
    private final AssumedSetting mute = new AssumedSetting();
    private volatile long beepNanos;

    BuzzerParameters(PioneerAccess access, TimeSource time) {
        this.access = access;
        this.time = time;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        table.add(Parameter.onOff("beep", "tones, to find out which robot it is"), this::beeping)
                .writes(values -> beep(values.get(0).isYes()));
        table.add(Parameter.onOff("mute", "whether the buzzer keeps silent"), access.assumed(mute))
                .writes(values -> access.send(
                        mute, ArcosCommand.SOUNDTOG.packet(values.get(0).isYes() ? 0 : 1), values.get(0)));
    }

    private void beep(boolean on) {
        access.send(ArcosCommand.SAY.packet(on ? TONES : SILENCE));
        beepNanos = on ? time.nanos() : 0;
    }

    private Value beeping() {
        long started = beepNanos;
        return Value.onOff(started != 0 && time.secondsSince(started) < TONES_S);
    }
}
