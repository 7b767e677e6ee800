package majic.pioneer.parameters;

import majic.pioneer.arcos.ArcosCommand;

/** Switches motors and sonars on and off, and waits for the SIP that confirms it. */
final class PowerSwitches {
    private static final int ALL_ARRAYS = 0;

    private final PioneerAccess access;

    PowerSwitches(PioneerAccess access) {
        this.access = access;
    }

    void motors(boolean on) {
        if (on) {
            access.open().motors().announceOn();
        }
        access.sendAndConfirm(
                ArcosCommand.ENABLE.packet(on ? 1 : 0),
                state -> state.motorsOn() == on,
                "the motors " + didNotSwitch(on));
    }

    void sonar(boolean on) {
        access.sendAndConfirm(
                ArcosCommand.SONAR.packet(sonarArgument(ALL_ARRAYS, on)),
                state -> state.sonarOn() == on,
                "the sonars " + didNotSwitch(on));
    }

    /** One array, 1 to 4. */
    void sonar(int array, boolean on) {
        access.sendAndConfirm(
                ArcosCommand.SONAR.packet(sonarArgument(array, on)),
                state -> state.sonarOn(array) == on,
                "sonar array " + array + " " + didNotSwitch(on));
    }

    /** Bit 0 switches, a bit above chooses the array, none all of them (ARCOS sheet 6.1). */
    private static int sonarArgument(int array, boolean on) {
        return (array == ALL_ARRAYS ? 0 : 1 << array) | (on ? 1 : 0);
    }

    private static String didNotSwitch(boolean on) {
        return "did not switch " + (on ? "on" : "off");
    }
}
