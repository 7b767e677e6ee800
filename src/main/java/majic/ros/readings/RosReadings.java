package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import majic.bot.LinkLost;
import majic.bot.RangeSensor;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.ros.bridge.TopicSubscription;
import majic.ros.message.BatteryMessage;
import majic.ros.message.CompressedPicture;
import majic.ros.message.ContactMessage;
import majic.ros.message.FrameTransform;
import majic.ros.message.FrameTree;
import majic.ros.message.HazardsMessage;
import majic.ros.message.ImuMessage;
import majic.ros.message.JointsMessage;
import majic.ros.message.LaserScanMessage;
import majic.ros.message.OdometryMessage;
import majic.ros.message.RangeMessage;
import majic.ros.message.StampClock;
import majic.ros.message.UnusableMessage;
import org.jspecify.annotations.Nullable;

/**
 * What the sensors of one robot report on one connection. Distances, contacts and the battery are subscribed to from
 * the start, because guards, maps and recordings read them all the time; everything else only while something reads it.
 * Thread-safe.
 */
public final class RosReadings {
    /** Ten scans a second are more than any guard needs, and half of what some scanners send. */
    private static final int SCAN_MS = 100;

    private static final int CONTACT_MS = 50;
    private static final int SLOW_MS = 1000;
    private static final int PICTURE_MS = 200;
    private static final double DISTANCE_FRESH_S = 1;
    private static final double HAZARD_FRESH_S = 5;
    private static final double BATTERY_FRESH_S = 60;
    private static final double UNUSED_S = 10;
    private static final double PICTURE_UNUSED_S = 2;

    /** More topics at a time are a mistake of a script; each costs the robot's network. */
    private static final int MOST_REQUESTED = 100;

    private static final List<String> BASES = List.of("base_link", "base_footprint");

    private final RosClient connection;
    private final RosSensors sensors;
    private final RobotWait waiting;
    private final Events events;
    private final Newest<ScanPoints> scan;
    private final StampClock scanStamps;
    private final Newest<BatteryMessage> battery;
    private final Newest<HazardsMessage> hazardList;
    private final Map<String, Newest<RangeMessage>> ranges = new LinkedHashMap<>();
    private final List<ScanTopic> scanTopics;
    private final Map<String, StampClock> scanTopicStamps = new ConcurrentHashMap<>();
    private final ActiveHazards hazards;
    private final Map<String, String> complaints = new ConcurrentHashMap<>();
    private final Map<String, RequestedReading<JsonNode>> requested = new ConcurrentHashMap<>();
    private final @Nullable RequestedReading<ImuMessage> imu;
    private final @Nullable RequestedReading<JointsMessage> joints;
    private final @Nullable RequestedReading<CompressedPicture> camera;
    private volatile FrameTree frames = FrameTree.EMPTY;
    private volatile @Nullable OdometryMessage odometry;

    /** Handles what arrives. Called on the reader thread, which must not wait. */
    public interface Events {
        /** Something can be read anew. */
        void news();

        /** Handles a picture of the camera. */
        void picture(CompressedPicture picture);

        /**
         * Handles what a range sensor has measured, while scans are requested.
         *
         * @param sensor where its beams are
         * @param measuredNanos when, on the driver's clock
         * @param rangesMm a range for each beam, mm, infinite or not a number
         */
        void scanned(RangeSensor sensor, long measuredNanos, float... rangesMm);

        /** Handles a message for the user, sent once for each topic. */
        void notice(String message);
    }

    /**
     * Readings of which nothing has arrived yet; subscribes to nothing.
     *
     * @param connection with the robot
     * @param sensors which it has
     * @param waiting the robot's clock and signal
     * @param events handles what arrives
     */
    public RosReadings(RosClient connection, RosSensors sensors, RobotWait waiting, Events events) {
        this.connection = connection;
        this.sensors = sensors;
        this.waiting = waiting;
        this.events = events;
        this.scan = new Newest<>(waiting.time(), DISTANCE_FRESH_S);
        this.scanStamps = stamps();
        this.battery = new Newest<>(waiting.time(), BATTERY_FRESH_S);
        this.hazardList = new Newest<>(waiting.time(), HAZARD_FRESH_S);
        this.hazards = new ActiveHazards(waiting.time());
        sensors.ranges().forEach(topic -> ranges.put(topic.name(), new Newest<>(waiting.time(), DISTANCE_FRESH_S)));
        this.scanTopics = ScanTopic.of(sensors, new Scanning());
        this.imu = onRequest(sensors.imu(), ImuMessage::from);
        this.joints = onRequest(sensors.joints(), JointsMessage::from);
        this.camera = sensors.camera()
                .map(topic -> RequestedReading.streamed(
                        connection.large(), topic.each(PICTURE_MS), this::picture, waiting, PICTURE_UNUSED_S))
                .orElse(null);
    }

    private <T> @Nullable RequestedReading<T> onRequest(Optional<RosTopic> topic, Function<JsonNode, T> reader) {
        return topic.map(known ->
                        RequestedReading.streamed(connection.sensors(), known.each(SCAN_MS), reader, waiting, UNUSED_S))
                .orElse(null);
    }

    private CompressedPicture picture(JsonNode message) {
        CompressedPicture picture = CompressedPicture.from(message);
        events.picture(picture);
        return picture;
    }

    /**
     * Subscribes to what is read all the time. Returns at once.
     *
     * @throws LinkLost if the connection is lost
     */
    public void begin() {
        // Each publisher of fixed frames keeps one message, and all of them arrive at once.
        sensors.fixedFrames()
                .ifPresent(topic -> observe(
                        topic,
                        new TopicSubscription(topic.name(), topic.type(), 0, 100, false),
                        message -> frames = frames.with(message),
                        () -> {}));
        sensors.scan().ifPresent(topic -> observe(topic, topic.each(SCAN_MS), this::scanned, scan::lost));
        sensors.ranges().forEach(this::beginRange);
        sensors.battery()
                .ifPresent(topic -> observe(
                        topic,
                        topic.each(SLOW_MS),
                        message -> battery.arrived(batteryOf(topic, message)),
                        battery::lost));
        sensors.hazards().ifPresent(topic -> subscribe(topic, topic.each(CONTACT_MS), this::hazardsListed));
        sensors.contacts().forEach(this::beginContacts);
        scanTopics.forEach(ScanTopic::begin);
    }

    private void beginRange(RosTopic topic) {
        Newest<RangeMessage> range = range(topic);
        StampClock stamps = stamps();
        observe(
                topic,
                topic.each(SCAN_MS),
                message -> range.measured(RangeMessage.from(message), measuredNanos(stamps, message)),
                range::lost);
    }

    private static BatteryMessage batteryOf(RosTopic topic, JsonNode message) {
        return switch (topic.shortType()) {
            case RosSensors.SPOT_BATTERIES -> BatteryMessage.spot(message);
            case RosSensors.CORE_SENSORS -> BatteryMessage.kobuki(message);
            default -> BatteryMessage.from(message);
        };
    }

    /** Each event of a Kobuki counts, so none may be left out; core sensors are repeated. */
    private void beginContacts(RosTopic topic) {
        boolean repeated = topic.shortType().equals(RosSensors.CORE_SENSORS);
        TopicSubscription wanted =
                new TopicSubscription(topic.name(), topic.type(), repeated ? CONTACT_MS : 0, repeated ? 1 : 100, false);
        subscribe(topic, wanted, message -> hazards.arrived(contactsOf(topic, message)));
    }

    private static ContactMessage contactsOf(RosTopic topic, JsonNode message) {
        if (!topic.shortType().equals(RosSensors.CORE_SENSORS)) {
            return ContactMessage.kobuki(message);
        }
        return topic.plainType().startsWith("turtlebot3_msgs/")
                ? ContactMessage.turtleBot3(message)
                : ContactMessage.kobukiCore(message);
    }

    /** Reads what ends a motion, on the connection that drives the robot. */
    private void subscribe(RosTopic topic, TopicSubscription wanted, Consumer<JsonNode> reader) {
        connection.subscribe(wanted, message -> read(topic, message, reader));
    }

    /** Reads a sensor, on a connection whose loss makes its readings none. */
    private void observe(RosTopic topic, TopicSubscription wanted, Consumer<JsonNode> reader, Runnable lost) {
        connection.sensors().subscribe(wanted, new TopicSource.Receiver() {
            @Override
            public void message(JsonNode message, int bytes) {
                read(topic, message, reader);
            }

            @Override
            public void lost() {
                lost.run();
                events.news();
            }
        });
    }

    private void read(RosTopic topic, JsonNode message, Consumer<JsonNode> reader) {
        try {
            reader.accept(message);
            events.news();
        } catch (UnusableMessage e) {
            complain(topic, e);
        }
    }

    private void complain(RosTopic topic, UnusableMessage reason) {
        if (complaints.put(topic.name(), String.valueOf(reason.getMessage())) == null) {
            events.notice("messages of the topic " + topic.name() + " are ignored: " + reason.getMessage());
        }
    }

    private void scanned(JsonNode message) {
        LaserScanMessage read = LaserScanMessage.from(message);
        scan.measured(ScanPoints.of(read, onRobot(read.frame())), measuredNanos(scanStamps, message));
    }

    private StampClock stamps() {
        return new StampClock(!connection.hasSimulatedTime());
    }

    private long measuredNanos(StampClock stamps, JsonNode message) {
        return stamps.measuredNanos(
                message, waiting.time().nanos(), connection.sensors().roundTripS());
    }

    private void hazardsListed(JsonNode message) {
        HazardsMessage read = HazardsMessage.from(message);
        hazardList.arrived(read);
        hazards.arrived(read);
    }

    /** Where a sensor is on the robot; in its centre if that is not reported. */
    private FrameTransform onRobot(String frame) {
        return place(frame).orElse(FrameTransform.NONE);
    }

    private Optional<FrameTransform> place(String frame) {
        FrameTree known = frames;
        return known.find(frame, base())
                .or(() -> BASES.stream()
                        .map(name -> known.find(frame, name))
                        .flatMap(Optional::stream)
                        .findFirst());
    }

    /**
     * Takes the newest odometry, which names the frames in which sensors and goals are placed.
     *
     * @param newest as it arrived
     */
    public void odometry(OdometryMessage newest) {
        odometry = newest;
    }

    /**
     * Returns the odometry.
     *
     * @return the newest message; empty before the first one
     */
    public Optional<OdometryMessage> odometry() {
        return Optional.ofNullable(odometry);
    }

    private String base() {
        OdometryMessage known = odometry;
        return known == null ? "" : known.base();
    }

    /** Ends the subscriptions that nothing reads. Called about once a second. */
    public void endUnused() {
        if (imu != null) {
            imu.endIfUnused();
        }
        if (joints != null) {
            joints.endIfUnused();
        }
        if (camera != null) {
            camera.endIfUnused();
        }
        requested.values().forEach(RequestedReading::endIfUnused);
    }

    /**
     * Returns the sensors of the robot.
     *
     * @return as found while it was connected
     */
    public RosSensors sensors() {
        return sensors;
    }

    /**
     * Returns the connection.
     *
     * @return open or lost
     */
    public RosClient connection() {
        return connection;
    }

    /**
     * Returns the echoes of the scanner.
     *
     * @return the newest scan
     */
    public Newest<ScanPoints> scan() {
        return scan;
    }

    /**
     * Returns the battery.
     *
     * @return its newest state
     */
    public Newest<BatteryMessage> battery() {
        return battery;
    }

    /**
     * Returns the single beam of a topic.
     *
     * @param topic one of {@link RosSensors#ranges}
     * @return its newest reading
     */
    public Newest<RangeMessage> range(RosTopic topic) {
        Newest<RangeMessage> known = ranges.get(topic.name());
        return known == null ? new Newest<>(waiting.time(), DISTANCE_FRESH_S) : known;
    }

    /**
     * Returns what contacts and cliff sensors report.
     *
     * @return the hazards on this connection
     */
    public ActiveHazards hazards() {
        return hazards;
    }

    /**
     * Returns whether the contacts are reported.
     *
     * @return false if the list of hazards, which a robot repeats, has not arrived of late
     */
    public boolean hasContacts() {
        return !sensors.contacts().isEmpty() || hazardList.get().isPresent();
    }

    /**
     * Returns whether every sensor of distances has sent a reading of late, or one at all if it is read on request.
     *
     * @return true for a robot without such sensors
     */
    public boolean hasDistances() {
        return (sensors.scan().isEmpty() || scan.get().isPresent())
                && ranges.values().stream().allMatch(range -> range.get().isPresent())
                && scanTopics.stream().allMatch(ScanTopic::isFound);
    }

    /**
     * Returns the range sensors, by their newest messages.
     *
     * @return scanners and single beams that have sent a message and measure along the floor
     */
    public List<RangeSensor> rangeSensors() {
        return scanTopics.stream()
                .map(ScanTopic::sensor)
                .flatMap(Optional::stream)
                .toList();
    }

    /**
     * Begins or ends to request all scans. Waits for nothing.
     *
     * @param requested does nothing if that is so already
     * @throws LinkLost if the connection is lost
     */
    public void requestScans(boolean requested) {
        scanTopics.forEach(topic -> topic.request(requested));
    }

    /**
     * Returns the inertial unit.
     *
     * @return empty if the robot has none
     */
    public Optional<RequestedReading<ImuMessage>> imu() {
        return Optional.ofNullable(imu);
    }

    /**
     * Returns the joints.
     *
     * @return empty if the robot reports none
     */
    public Optional<RequestedReading<JointsMessage>> joints() {
        return Optional.ofNullable(joints);
    }

    /**
     * Returns the camera.
     *
     * @return empty if the robot has none; pictures arrive while something reads it
     */
    public Optional<RequestedReading<CompressedPicture>> camera() {
        return Optional.ofNullable(camera);
    }

    /**
     * Returns the messages of any topic.
     *
     * @param topic its name and type
     * @return the newest message, subscribed to while something reads it; empty if too many topics are read already
     */
    public Optional<RequestedReading<JsonNode>> topic(RosTopic topic) {
        if (requested.size() >= MOST_REQUESTED && !requested.containsKey(topic.name())) {
            return Optional.empty();
        }
        return Optional.of(requested.computeIfAbsent(
                topic.name(),
                name -> RequestedReading.sampled(
                        connection.large(), topic.each(SCAN_MS), message -> message, waiting, UNUSED_S)));
    }

    /**
     * Returns the distance on one side of the robot.
     *
     * @param side which
     * @param radiusMm of the robot
     * @param noEcho what it means that a beam has none
     * @return mm from the hull, clear, or unknown with the reason
     */
    public Value distance(HullSide side, double radiusMm, NoEcho noEcho) {
        Optional<ScanPoints> points = scan.get();
        List<HullDistances.Beam> beams = new ArrayList<>();
        for (Newest<RangeMessage> each : ranges.values()) {
            each.get()
                    .ifPresent(reading -> place(reading.frame())
                            .ifPresent(place -> beams.add(new HullDistances.Beam(reading, place))));
        }
        if (points.isEmpty() && sensors.scan().isPresent()) {
            return scan.unknown();
        }
        return new HullDistances(radiusMm, noEcho).distance(side, points, beams);
    }

    /** The robot as its range sensors use it. */
    private final class Scanning implements ScanTopic.Robot {
        @Override
        public TopicSource source() {
            return connection.sensors();
        }

        @Override
        public Optional<FrameTransform> place(String frame) {
            return RosReadings.this.place(frame);
        }

        @Override
        public void found() {
            waiting.changes().raise();
        }

        @Override
        public void unusable(RosTopic topic, UnusableMessage reason) {
            complain(topic, reason);
        }

        @Override
        public void scanned(RosTopic topic, RangeSensor sensor, JsonNode message, float... rangesMm) {
            StampClock stamps = scanTopicStamps.computeIfAbsent(topic.name(), name -> stamps());
            events.scanned(sensor, measuredNanos(stamps, message), rangesMm);
        }
    }
}
