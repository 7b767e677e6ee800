package majic.shared.panel;

import java.util.Set;
import majic.panel.ReadingText;
import majic.text.Texts;

/**
 * The labels of readings in the user's language: the description of a shared robot has only the names of its
 * parameters, and this desk may not have its driver.
 */
final class SharedLabels {
    private static final Texts TEXTS = Texts.of(SharedLabels.class);

    /** The parameters of Aibo, Pioneer, Hemisson and ROS robots that the panel shows. */
    private static final Set<String> KNOWN = Set.of(
            "distanceFront",
            "distanceLeft",
            "distanceBack",
            "distanceRight",
            "distanceNear",
            "distance",
            "distanceFar",
            "distanceChest",
            "x",
            "y",
            "heading",
            "bumped",
            "temperature",
            "faults",
            "lowVoltage",
            "charger",
            "stallLeft",
            "stallRight",
            "stopButton",
            "stopEngaged",
            "ledge",
            "wheelLeft",
            "wheelRight",
            "groundLeft",
            "groundRight",
            "speedLeft",
            "speedRight",
            "scanNearest",
            "scanBearing",
            "scanBeams",
            "scanEchoes",
            "roll",
            "pitch",
            "compass",
            "gyro",
            "accelX",
            "accelY",
            "accelZ",
            "headSensor",
            "backSensorF",
            "backSensorM",
            "backSensorR",
            "chinSensor",
            "pawLF",
            "pawRF",
            "pawLH",
            "pawRH",
            "playing",
            "ball");

    private SharedLabels() {}

    /** Returns the label of a parameter; one that is not known here has its name in plain English words. */
    static String of(String parameter) {
        return KNOWN.contains(parameter) ? TEXTS.get(parameter) : ReadingText.label(parameter);
    }
}
