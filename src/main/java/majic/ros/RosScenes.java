package majic.ros;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.bot.BotProfile;
import majic.bot.MajicBot;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicActivity;
import majic.ros.message.BatteryMessage;
import majic.ros.message.BatteryMessage.Supply;
import majic.ros.panel.RosScene;
import majic.ros.panel.ScanEchoes;
import majic.ros.readings.Newest;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;
import majic.ros.readings.ScanPoints;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Makes the snapshots that the panel shows and recordings keep. Asks the robot for nothing. Thread-safe. */
final class RosScenes {
    private final TimeSource time;
    private final MessageRate rate = new MessageRate();
    private volatile @Nullable Converted converted;

    /** A scan, and what the panel gets for it. */
    private record Converted(ScanPoints from, ScanEchoes to) {}

    RosScenes(TimeSource time) {
        this.time = time;
    }

    /**
     * Makes a snapshot.
     *
     * @param bot the robot
     * @param connections those of its session
     * @param readings of that session
     */
    RosScene scene(MajicBot bot, RosConnections connections, RosReadings readings) {
        List<TopicActivity> activity = connections.activity().stream()
                .sorted(Comparator.comparing(TopicActivity::topic))
                .toList();
        double silenceS = connections.all().stream()
                .mapToDouble(RosBridge::silenceS)
                .max()
                .orElse(0);
        long messages = activity.stream().mapToLong(TopicActivity::count).sum();
        return new RosScene(
                robot(bot.profile(), readings),
                bot.connection(),
                new RosScene.Link(silenceS, rate.at(messages, time.nanos())),
                scan(readings.scan()),
                readings.hazards().now().stream()
                        .map(report -> new RosScene.Contact(report.hazard(), report.place()))
                        .toList(),
                readings.battery().get().map(RosScenes::battery).orElse(RosScene.Battery.UNKNOWN),
                activity.stream()
                        .map(topic -> new RosScene.Topic(topic.topic(), topic.type(), topic.ageS()))
                        .toList());
    }

    private static RosScene.Robot robot(BotProfile profile, RosReadings readings) {
        RosSensors sensors = readings.sensors();
        return new RosScene.Robot(
                profile.bodyMm(),
                profile.speed(),
                profile.turn(),
                sensors.scan().isPresent(),
                sensors.hazards().isPresent() || !sensors.contacts().isEmpty(),
                sensors.camera().isPresent());
    }

    /** Converts each scan once: it is read more often than it arrives. */
    private Optional<ScanEchoes> scan(Newest<ScanPoints> newest) {
        return newest.get().map(points -> {
            Converted last = converted;
            if (last == null || last.from() != points) {
                long atNanos = time.nanos() - (long) (newest.ageS() * 1e9);
                last = new Converted(points, echoes(points, atNanos));
                converted = last;
            }
            return last.to();
        });
    }

    private static ScanEchoes echoes(ScanPoints points, long atNanos) {
        double[] x = new double[points.beams()];
        double[] y = new double[points.beams()];
        for (int beam = 0; beam < x.length; beam++) {
            x[beam] = points.xMm(beam);
            y[beam] = points.yMm(beam);
        }
        return ScanEchoes.of(x, y, atNanos);
    }

    private static RosScene.Battery battery(BatteryMessage battery) {
        OptionalDouble percent = battery.percent();
        return new RosScene.Battery(
                battery.volts(),
                percent.isPresent() ? OptionalInt.of((int) Math.round(percent.getAsDouble())) : OptionalInt.empty(),
                battery.supply() == Supply.CHARGING,
                battery.supply().words());
    }
}
