package majic.aibo.body;

import java.util.Arrays;
import java.util.List;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Range;

/** The 18 joints with the angles that they can take, degrees (URBI sheet 13). */
public enum Joint {
    NECK("neck", Sensor.NECK, -79, 2, "how far the neck is bowed; 0 is upright"),
    HEAD_PAN("headPan", Sensor.HEAD_PAN, -91, 91, "where the head looks, left positive"),
    HEAD_TILT("headTilt", Sensor.HEAD_TILT, -16, 44, "how far the head is raised"),
    MOUTH("mouth", Sensor.MOUTH, -58, -3, "how far the mouth is open; -3 is shut"),
    TAIL_PAN("tailPan", Sensor.TAIL_PAN, -59, 59, "where the tail points"),
    TAIL_TILT("tailTilt", Sensor.TAIL_TILT, 2, 63, "how far the tail is raised"),
    LEG_LF1("legLF1", Sensor.LEG_LF1, -120, 134, Part.SWING),
    LEG_LF2("legLF2", Sensor.LEG_LF2, -9, 91, Part.SPREAD),
    LEG_LF3("legLF3", Sensor.LEG_LF3, -29, 119, Part.KNEE),
    LEG_RF1("legRF1", Sensor.LEG_RF1, -134, 120, Part.SWING),
    LEG_RF2("legRF2", Sensor.LEG_RF2, -9, 91, Part.SPREAD),
    LEG_RF3("legRF3", Sensor.LEG_RF3, -29, 119, Part.KNEE),
    LEG_LH1("legLH1", Sensor.LEG_LH1, -120, 134, Part.SWING),
    LEG_LH2("legLH2", Sensor.LEG_LH2, -9, 91, Part.SPREAD),
    LEG_LH3("legLH3", Sensor.LEG_LH3, -29, 119, Part.KNEE),
    LEG_RH1("legRH1", Sensor.LEG_RH1, -134, 120, Part.SWING),
    LEG_RH2("legRH2", Sensor.LEG_RH2, -9, 91, Part.SPREAD),
    LEG_RH3("legRH3", Sensor.LEG_RH3, -29, 119, Part.KNEE);

    /** Which joint of a leg it is, counted from the body, with what the scripts of 1.5 allow it. */
    private enum Part {
        SWING("first joint of a leg, which swings it forward and back", new Range(-120, 134)),
        SPREAD("second joint of a leg, which spreads it sideways", new Range(-15, 93)),
        KNEE("third joint of a leg, its knee", new Range(-30, 127));

        private final String help;
        private final Range rangeOf15;

        Part(String help, Range rangeOf15) {
            this.help = help;
            this.rangeOf15 = rangeOf15;
        }
    }

    private final String urbiName;
    private final Sensor sensor;
    private final Range range;
    private final Range rangeOf15;
    private final String help;

    Joint(String urbiName, Sensor sensor, double min, double max, String help) {
        this.urbiName = urbiName;
        this.sensor = sensor;
        this.range = new Range(min, max);
        this.rangeOf15 = range;
        this.help = help;
    }

    Joint(String urbiName, Sensor sensor, double min, double max, Part part) {
        this.urbiName = urbiName;
        this.sensor = sensor;
        this.range = new Range(min, max);
        this.rangeOf15 = part.rangeOf15;
        this.help = part.help;
    }

    /** As the dog and the user call it. */
    public String urbiName() {
        return urbiName;
    }

    /** What measures it. */
    public Sensor sensor() {
        return sensor;
    }

    /** The angles that a generation of sticks allows; beyond them the dog clips without a word (URBI sheet 6). */
    public Range range(UrbiVersion version) {
        return switch (version) {
            case V1_0 -> range;
            case V1_5 -> rangeOf15;
        };
    }

    public String help() {
        return help;
    }

    public boolean isInALeg() {
        return urbiName.startsWith("leg");
    }

    /** All joints whose names begin so, in their usual order. */
    public static List<Joint> named(String beginning) {
        return Arrays.stream(values())
                .filter(joint -> joint.urbiName.startsWith(beginning))
                .toList();
    }
}
