package majic.ros.parameters;

import java.util.Optional;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.message.CompressedPicture;
import majic.ros.readings.RequestedReading;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;

/** The camera; subscribed to while a panel shows it or something reads these parameters. */
final class RosCameraParameters implements ParameterTheme<RosSensors> {
    private static final double BYTES_PER_KB = 1000;

    private final RosAccess access;

    RosCameraParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.camera().isEmpty()) {
            return;
        }
        table.add(
                Parameter.text("camera", "format and size of the newest picture; requested when read"),
                access.requested(RosReadings::camera, RosCameraParameters::words));
        table.add(
                Parameter.number("cameraAge", Unit.MS, "time since the newest picture; requests none"),
                access.read(readings -> age(readings.camera())));
    }

    private static Value words(CompressedPicture picture) {
        return Value.text(picture.format() + ", " + Value.plain(picture.size() / BYTES_PER_KB) + " kB");
    }

    private static Value age(Optional<RequestedReading<CompressedPicture>> camera) {
        double ageS = camera.map(RequestedReading::ageS).orElse(Double.POSITIVE_INFINITY);
        return Double.isFinite(ageS) ? Value.of(ageS * 1000, Unit.MS) : Value.unknown("no picture yet");
    }
}
