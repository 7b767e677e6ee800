package majicsim.aibo;

import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.value.Value;

/** A lamp or an ear that is only on or off (URBI sheet, section 13): from one half on it is on. */
final class OnOff implements Variable.Hardware {
    private static final double ENOUGH = 0.5;

    private boolean on;

    @Override
    public Value measure() {
        return Value.of(on);
    }

    @Override
    public void command(double target) {
        on = target >= ENOUGH;
    }
}
