package majic.aibo.body;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.driver.DeadReckoning;
import org.jspecify.annotations.Nullable;

/** Holds the dog's readings, the obstacles around it and its estimated position. Outlives a connection. Thread-safe. */
public final class DogState {
    private static final String FLOOR = "floor";

    private final Calibration calibration;
    private final SensorReadings senses = new SensorReadings();
    private final LedReadings leds = new LedReadings();
    private final InfraRed infraRed = new InfraRed(senses);
    private final RecentObstacles obstacles = new RecentObstacles();
    private final LegSpeed legSpeed = new LegSpeed();
    private final DeadReckoning reckoning = new DeadReckoning();
    private final AtomicReference<@Nullable String> stopCommands = new AtomicReference<>();
    private volatile boolean standing;
    private volatile long serverMs;
    private volatile long measuredNanos;

    public DogState(Calibration calibration) {
        this.calibration = calibration;
    }

    public Calibration calibration() {
        return calibration;
    }

    public SensorReadings senses() {
        return senses;
    }

    public LedReadings leds() {
        return leds;
    }

    public InfraRed infraRed() {
        return infraRed;
    }

    public LegSpeed legSpeed() {
        return legSpeed;
    }

    public DeadReckoning reckoning() {
        return reckoning;
    }

    /** Whether it was brought to its feet and nothing has been done since that could have changed that. */
    public boolean isStanding() {
        return standing && senses.motorsOn().orElse(true);
    }

    public void setStanding(boolean stands) {
        standing = stands;
        if (stands) {
            infraRed.standing();
        }
    }

    /** Forgets the readings of an earlier connection. */
    public void forgetReadings() {
        senses.clear();
        leds.clear();
        obstacles.clear();
        standing = false;
    }

    /** Keeps the commands that end what a lost connection may have left running, for the next connection. */
    public void keepStopCommands(String commands) {
        stopCommands.set(commands);
    }

    /** Removes and returns the commands that a lost connection left; empty if there are none. */
    public Optional<String> takeStopCommands() {
        return Optional.ofNullable(stopCommands.getAndSet(null));
    }

    /**
     * A set of fast readings is complete.
     *
     * @param atServerMs when the dog measured it, by its own clock
     * @param atNanos the same time on this computer's clock
     */
    public void sensed(long atServerMs, long atNanos) {
        serverMs = atServerMs;
        measuredNanos = atNanos;
        Pose pose = reckoning.at(atServerMs);
        double pan = senses.number(Sensor.HEAD_PAN).orElse(0.0);
        obstacles.add(pose, pan, infraRed.headMm(), atServerMs);
        obstacles.add(pose, 0, infraRed.chestMm(), atServerMs);
    }

    /**
     * When the newest set of fast readings was measured, by the dog's clock, ms; the estimated pose is of this time.
     */
    public long sensedMs() {
        return serverMs;
    }

    /** The nearest thing in the way ahead, mm from the hull; empty if there is none. */
    public Optional<Double> frontMm() {
        return obstacles.frontMm(reckoning.at(serverMs));
    }

    /** What it shares with all robots, while it walks a piece or none. */
    public BotState state(@Nullable GaitPiece piece, boolean moving) {
        double pace = piece == null ? 0 : piece.unitsPerSecond();
        boolean walks = piece != null && piece.gait().isWalk();
        return new BotState(reckoning.at(serverMs), walks ? pace : 0, walks ? 0 : pace, moving, measuredNanos);
    }

    /** The readings of sensors and LEDs as texts, for recordings. */
    public Map<String, String> texts() {
        Map<String, String> texts = new LinkedHashMap<>();
        senses.addTexts(texts);
        leds.addTexts(texts);
        texts.put(FLOOR, String.valueOf(infraRed.floorCm()));
        return texts;
    }

    /**
     * Takes the readings of a recorded dog.
     *
     * @param texts what {@link #texts()} has returned
     * @param pose where it was
     * @param atMs when that was
     */
    public void restore(Map<String, String> texts, Pose pose, long atMs) {
        senses.restore(texts);
        leds.restore(texts);
        infraRed.setFloorCm(Double.parseDouble(texts.getOrDefault(FLOOR, "NaN")));
        reckoning.begin((start, time) -> pose, atMs);
        sensed(atMs, measuredNanos);
    }
}
