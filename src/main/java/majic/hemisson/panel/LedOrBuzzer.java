package majic.hemisson.panel;

import java.util.function.Predicate;
import majic.text.Texts;

/** The four LEDs and the buzzer, which can be clicked on the drawing; their places on the robot, mm. */
enum LedOrBuzzer {
    LEFT("ledLeft", 34, 25, view -> view.leds().left()),
    RIGHT("ledRight", 34, -25, view -> view.leds().right()),
    ON_OFF("ledOnOff", -14, 24, view -> view.leds().onOff()),
    PGM("ledPgm", -14, -24, view -> view.leds().pgm()),
    BUZZER("beep", -14, 0, HemissonScene::buzzing);

    private static final Texts TEXTS = Texts.of(LedOrBuzzer.class);

    private final String parameter;
    private final double xMm;
    private final double yMm;
    private final Predicate<HemissonScene> reader;

    LedOrBuzzer(String parameter, double xMm, double yMm, Predicate<HemissonScene> reader) {
        this.parameter = parameter;
        this.xMm = xMm;
        this.yMm = yMm;
        this.reader = reader;
    }

    /** The parameter that switches it. */
    String parameter() {
        return parameter;
    }

    String words() {
        return TEXTS.get(parameter);
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
