package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import majic.bot.RangeSensor;
import majic.ros.message.FrameTransform;
import majic.ros.message.LaserScanMessage;
import majic.ros.message.RangeMessage;
import majic.ros.message.UnusableMessage;
import org.jspecify.annotations.Nullable;

/**
 * A range sensor of a robot and what it measures, by the messages of its topic. The first message, which describes the
 * sensor, is requested at once; the others only while something asks for scans, and then all of them. Thread-safe.
 */
final class ScanTopic implements TopicSource.Receiver {
    private static final String LASER = "laser";

    private final String name;
    private final RosTopic topic;
    private final Robot robot;
    private volatile @Nullable BeamLayout layout;
    private volatile @Nullable Described described;
    private volatile boolean requested;
    private @Nullable Runnable unsubscribe;

    /** The robot of the sensor. Called on the reader thread, which must not wait. */
    interface Robot {
        /** The connection for sensors. */
        TopicSource source();

        /** Where a frame is on the robot; empty if that is not reported. */
        Optional<FrameTransform> place(String frame);

        /** Wakes what waits for the first message of a topic: its sensor can be described. */
        void found();

        /** Handles a message of a topic that cannot be used. */
        void unusable(RosTopic topic, UnusableMessage reason);

        /** Handles ranges, mm, with the message that they came in. */
        void scanned(RosTopic topic, RangeSensor sensor, JsonNode message, float... rangesMm);
    }

    /** What one message has. */
    private record Measured(BeamLayout layout, IntToDoubleFunction mm) {
        float[] rangesMm() {
            float[] ranges = new float[layout.count()];
            for (int beam = 0; beam < ranges.length; beam++) {
                double range = mm.applyAsDouble(beam);
                ranges[beam] = range > 0 ? (float) range : Float.NaN;
            }
            return ranges;
        }
    }

    /** The sensor that a layout gives at one place; none if it measures no distances along the floor. */
    private record Described(BeamLayout layout, FrameTransform mount, Optional<RangeSensor> sensor) {}

    private ScanTopic(String name, RosTopic topic, Robot robot) {
        this.name = name;
        this.topic = topic;
        this.robot = robot;
    }

    /** The range sensors of a robot: the scanners, then the single beams. Each has a name of its own. */
    static List<ScanTopic> of(RosSensors sensors, Robot robot) {
        boolean isAlone = sensors.scans().size() == 1
                && sensors.ranges().stream().noneMatch(topic -> relative(topic).equals(LASER));
        List<ScanTopic> all = new ArrayList<>();
        sensors.scans().forEach(topic -> all.add(new ScanTopic(isAlone ? LASER : relative(topic), topic, robot)));
        sensors.ranges().forEach(topic -> all.add(new ScanTopic(relative(topic), topic, robot)));
        return all;
    }

    private static String relative(RosTopic topic) {
        return topic.name().substring(1);
    }

    /** Requests one message, which describes the sensor. */
    synchronized void begin() {
        unsubscribe = robot.source().subscribe(topic.each(0).once(), this);
    }

    /** Requests all messages, or no more; does nothing if that is so already. Waits for nothing. */
    synchronized void request(boolean all) {
        if (all == requested) {
            return;
        }
        unsubscribe();
        if (all) {
            unsubscribe = robot.source().subscribe(topic.each(0), this);
        }
        requested = all;
    }

    private synchronized void endDescription() {
        if (!requested) {
            unsubscribe();
        }
    }

    private synchronized void unsubscribe() {
        Runnable end = unsubscribe;
        unsubscribe = null;
        if (end != null) {
            end.run();
        }
    }

    /** Whether a message has arrived. */
    boolean isFound() {
        return layout != null;
    }

    /** The sensor; empty before the first message, or if it measures no distances along the floor. */
    Optional<RangeSensor> sensor() {
        BeamLayout known = layout;
        return known == null ? Optional.empty() : sensor(known);
    }

    /** A scanner without a known place is taken to be in the centre of the robot; a single beam looks anywhere. */
    private Optional<RangeSensor> sensor(BeamLayout known) {
        return robot.place(known.frame())
                .or(() -> isSingle() ? Optional.empty() : Optional.of(FrameTransform.NONE))
                .flatMap(mount -> sensor(known, mount));
    }

    private Optional<RangeSensor> sensor(BeamLayout known, FrameTransform mount) {
        Described last = described;
        if (last == null || !last.layout().equals(known) || !last.mount().equals(mount)) {
            last = new Described(known, mount, known.sensor(name, mount));
            described = last;
        }
        return last.sensor();
    }

    @Override
    public void message(JsonNode message, int bytes) {
        try {
            Measured measured = read(message);
            boolean first = layout == null;
            layout = measured.layout();
            if (first) {
                robot.found();
            }
            if (requested) {
                sensor(measured.layout())
                        .ifPresent(sensor -> robot.scanned(topic, sensor, message, measured.rangesMm()));
            } else {
                endDescription();
            }
        } catch (UnusableMessage e) {
            robot.unusable(topic, e);
        }
    }

    private Measured read(JsonNode message) {
        if (isSingle()) {
            RangeMessage range = RangeMessage.from(message);
            return new Measured(BeamLayout.of(range), beam -> range.measuredMm());
        }
        LaserScanMessage scan = LaserScanMessage.from(message);
        return new Measured(BeamLayout.of(scan), scan::measuredMm);
    }

    private boolean isSingle() {
        return topic.shortType().equals("Range");
    }

    /** The connection is opened again, with the subscriptions that there are. */
    @Override
    public void lost() {}
}
