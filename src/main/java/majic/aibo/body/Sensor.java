package majic.aibo.body;

import java.util.Arrays;
import java.util.List;

/** The values that the dog reports periodically, with the expression that reads each (URBI sheet 13). */
public enum Sensor {
    NEAR("distanceNear.val", Rate.FAST),
    FAR("distance.val", Rate.FAST),
    CHEST("distanceChest.val", Rate.FAST),
    HEAD_PAN("headPan.val", Rate.FAST),
    HEAD_TILT("headTilt.val", Rate.SLOW),
    NECK("neck.val", Rate.SLOW),
    MOUTH("mouth.val", Rate.SLOW),
    TAIL_PAN("tailPan.val", Rate.SLOW),
    TAIL_TILT("tailTilt.val", Rate.SLOW),
    LEG_LF1("legLF1.val", Rate.SLOW),
    LEG_LF2("legLF2.val", Rate.SLOW),
    LEG_LF3("legLF3.val", Rate.SLOW),
    LEG_RF1("legRF1.val", Rate.SLOW),
    LEG_RF2("legRF2.val", Rate.SLOW),
    LEG_RF3("legRF3.val", Rate.SLOW),
    LEG_LH1("legLH1.val", Rate.SLOW),
    LEG_LH2("legLH2.val", Rate.SLOW),
    LEG_LH3("legLH3.val", Rate.SLOW),
    LEG_RH1("legRH1.val", Rate.SLOW),
    LEG_RH2("legRH2.val", Rate.SLOW),
    LEG_RH3("legRH3.val", Rate.SLOW),
    LEG_LOAD("legLF1.load", Rate.SLOW),
    ACCEL_X("accelX.val", Rate.SLOW),
    ACCEL_Y("accelY.val", Rate.SLOW),
    ACCEL_Z("accelZ.val", Rate.SLOW),
    PAW_LF("pawLF.val", Rate.SLOW),
    PAW_RF("pawRF.val", Rate.SLOW),
    PAW_LH("pawLH.val", Rate.SLOW),
    PAW_RH("pawRH.val", Rate.SLOW),
    CHIN("chinSensor.val", Rate.SLOW),
    HEAD_TOUCH("headSensor.val", Rate.SLOW),
    BACK_FRONT("backSensorF.val", Rate.SLOW),
    BACK_MIDDLE("backSensorM.val", Rate.SLOW),
    BACK_REAR("backSensorR.val", Rate.SLOW),
    WIFI_SWITCH("WIFIswitch.val", Rate.RARE),
    CHARGE("power()", Rate.RARE),
    POSTURE("robot.MyguessPosition()", Rate.RARE);

    /** How often. */
    public enum Rate {
        /** Values that can stop a moving dog: twice the dog's cycle of 32 ms. */
        FAST(64),
        /** Values that are displayed. */
        SLOW(256),
        /** Values that change slowly. */
        RARE(1024);

        private final int periodMs;

        Rate(int periodMs) {
            this.periodMs = periodMs;
        }

        public int periodMs() {
            return periodMs;
        }

        public List<Sensor> sensors() {
            return Arrays.stream(Sensor.values())
                    .filter(sensor -> sensor.rate == this)
                    .toList();
        }
    }

    private final String expression;
    private final Rate rate;

    Sensor(String expression, Rate rate) {
        this.expression = expression;
        this.rate = rate;
    }

    public String expression() {
        return expression;
    }

    /** The part of a tag that names it. */
    public String tagName() {
        return "s" + ordinal();
    }
}
