package majic.hemisson.panel;

import java.util.function.Predicate;

/** The four LEDs and the buzzer, which can be clicked on the drawing; their places on the robot, mm. */
enum LedOrBuzzer {
    LEFT("ledLeft", "front left LED", 34, 25, view -> view.leds().left()),
    RIGHT("ledRight", "front right LED", 34, -25, view -> view.leds().right()),
    ON_OFF(
            "ledOnOff",
            "On/Off LED; the robot takes it back within half a second",
            -14,
            24,
            view -> view.leds().onOff()),
    PGM("ledPgm", "Pgm/Exec LED", -14, -24, view -> view.leds().pgm()),
    BUZZER("beep", "buzzer", -14, 0, HemissonScene::buzzing);

    private final String parameter;
    private final String words;
    private final double xMm;
    private final double yMm;
    private final Predicate<HemissonScene> reader;

    LedOrBuzzer(String parameter, String words, double xMm, double yMm, Predicate<HemissonScene> reader) {
        this.parameter = parameter;
        this.words = words;
        this.xMm = xMm;
        this.yMm = yMm;
        this.reader = reader;
    }

    /** The parameter that switches it. */
    String parameter() {
        return parameter;
    }

    String words() {
        return words;
    }

    /** Ahead of the centre of the robot. */
    double xMm() {
        return xMm;
    }

    /** To the left of the centre of the robot. */
    double yMm() {
        return yMm;
    }

    /** Whether it is on, as far as the driver can tell. */
    boolean isOn(HemissonScene view) {
        return reader.test(view);
    }
}
