package majic.pioneer.aria;

import com.mobilerobots.Aria.ArArgumentParser;
import com.mobilerobots.Aria.ArLaser;
import com.mobilerobots.Aria.ArLaserConnector;
import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArRobotConnector;
import com.mobilerobots.Aria.ArSensorReading;
import com.mobilerobots.Aria.ArSensorReadingVector;
import com.mobilerobots.Aria.ArTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import org.jspecify.annotations.Nullable;

/**
 * The first laser of a robot, if ARIA has one to connect to: by {@code LaserAutoConnect} in its parameter file of the
 * robot, or by {@code -connectLaser} in its options (the environment variable {@code ARIAARGS}). Kept as long as ARIA's
 * object for the robot, and connected again for each of its connections. Signatures: ARIA 2.8.0 and 2.9.1.
 *
 * <p>Nothing here holds the lock of the robot, which a stop needs, and that of the laser is held for a copy only.
 */
class AriaLaser {
    private static final int FIRST = 1;
    private static final long OLD_MS = 1000;
    private static final double NOISE_MM = 10;
    private static final double WIDEST_OPENING_DEG = 1;

    /** The reach of a laser that states none: that of the farthest of ARIA's lasers of that time (SICK LMS-200). */
    private static final double REACH_MM = 32_000;

    private final ArRobot robot;
    private final AtomicReference<@Nullable ArLaser> connected = new AtomicReference<>();
    private volatile boolean wanted;
    private @Nullable ArLaserConnector connector;

    /** What ARIA's connector uses: its wrapper keeps no references. */
    private @Nullable ArArgumentParser options;

    private @Nullable ArRobotConnector simulation;
    private @Nullable ArTime lastRead;
    private @Nullable RangeSensor sensor;

    /** Creates one that is not connected; calls nothing of ARIA, which may lack the classes for lasers. */
    AriaLaser(ArRobot robot) {
        this.robot = robot;
    }

    /** Called with the first connection. */
    ArLaserConnector makeConnector() {
        options = new ArArgumentParser(new String[] {"majic"});
        options.loadDefaultArguments();
        simulation = new ArRobotConnector(options, robot);
        return new ArLaserConnector(options, robot, simulation);
    }

    /**
     * Connects to the laser of a connected robot. Blocks as long as ARIA tries, which may be a minute.
     *
     * @return false if there is one that ARIA cannot reach
     */
    boolean connect() {
        wanted = true;
        return tryToConnect();
    }

    /** One attempt after the other, since ARIA goes on with one when the robot has long been disconnected. */
    private synchronized boolean tryToConnect() {
        ArLaser before = connected.get();
        if (!wanted || before != null && before.isConnected()) {
            return true;
        }
        ArLaserConnector lasers = connector == null ? makeConnector() : connector;
        connector = lasers;
        boolean reached = lasers.connectLasers();
        ArLaser laser = lasers.getLaser(FIRST);
        if (laser != null && laser.isConnected()) {
            connected.set(laser);
        }
        if (!wanted) {
            disconnect();
        }
        return reached;
    }

    /** Ends its connection, if there is one. Blocks. */
    void disconnect() {
        wanted = false;
        ArLaser laser = connected.getAndSet(null);
        if (laser != null) {
            laser.disconnect();
        }
    }

    /**
     * The newest scan; to be called by one thread, that of the connection.
     *
     * @param nowNanos on the clock of the driver
     * @param base the pose that ARIA had for the robot when it reported it last
     * @return with the odometry relative to that pose; empty if there is no newer one than at the last call, or it is
     *     older than 1 s
     */
    Optional<RangeScan> scan(long nowNanos, Pose base) {
        ArLaser laser = connected.get();
        ArSensorReadingVector readings = laser == null ? null : newReadings(laser);
        int count = readings == null ? 0 : (int) readings.size();
        if (count == 0) {
            return Optional.empty();
        }
        ArSensorReading first = readings.get(0);
        ArTime taken = first.getTimeTaken();
        long ageMs = taken.mSecSince();
        taken.delete();
        if (ageMs > OLD_MS) {
            return Optional.empty();
        }
        RangeSensor now = sensor(readings, count, laser.getMaxRange());
        float[] rangesMm = new float[count];
        for (int beam = 0; beam < count; beam++) {
            rangesMm[beam] = rangeMm(readings.get(beam), now.beams().get(beam));
        }
        Pose at = new Pose(first.getXTaken(), first.getYTaken(), first.getThTaken());
        return Optional.of(new RangeScan(now, nowNanos / 1e9 - ageMs / 1e3, at.seenFrom(base), rangesMm));
    }

    /**
     * ARIA's copy of the readings, which changes with the next call only; null if there are no new ones, or the laser
     * is busy.
     */
    private @Nullable ArSensorReadingVector newReadings(ArLaser laser) {
        if (laser.tryLockDevice() != 0) {
            return null;
        }
        try {
            ArTime read = laser.getLastReadingTime();
            if (lastRead != null && read.isAt(lastRead)) {
                read.delete();
                return null;
            }
            if (lastRead != null) {
                lastRead.delete();
            }
            lastRead = read;
            return laser.getRawReadingsAsVector();
        } finally {
            laser.unlockDevice();
        }
    }

    /** From the place of the laser; ARIA marks those beyond its reach too as to be ignored. */
    private static float rangeMm(ArSensorReading reading, Beam beam) {
        double range = Math.hypot(
                reading.getLocalX() - beam.mount().xMm(),
                reading.getLocalY() - beam.mount().yMm());
        boolean measured = range > 0 && (range >= beam.reachMm() || !reading.getIgnoreThisReading());
        return measured ? (float) range : Float.NaN;
    }

    /** The same one as long as the laser measures in the same directions. */
    private RangeSensor sensor(ArSensorReadingVector readings, int count, long maxRange) {
        RangeSensor known = sensor;
        double reachMm = maxRange > 0 ? maxRange : REACH_MM;
        Pose first = mount(readings.get(0));
        if (known == null
                || known.beams().size() != count
                || known.beams().get(0).reachMm() != reachMm
                || !known.beams().get(0).mount().equals(first)) {
            double step = count > 1 ? mount(readings.get(1)).seenFrom(first).headingDeg() : 0;
            double opening = Math.min(Math.abs(step), WIDEST_OPENING_DEG);
            List<Beam> beams = new ArrayList<>();
            for (int beam = 0; beam < count; beam++) {
                beams.add(new Beam(mount(readings.get(beam)), opening, 0, reachMm, NOISE_MM));
            }
            known = new RangeSensor("laser", beams);
            sensor = known;
        }
        return known;
    }

    private static Pose mount(ArSensorReading reading) {
        return new Pose(reading.getSensorX(), reading.getSensorY(), reading.getSensorTh());
    }
}
