package majic.pioneer.aria;

import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyInt;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import com.mobilerobots.Aria.ArLaser;
import com.mobilerobots.Aria.ArLaserConnector;
import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArSensorReading;
import com.mobilerobots.Aria.ArSensorReadingVector;
import com.mobilerobots.Aria.ArTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.pioneer.session.RampModel;
import org.jspecify.annotations.Nullable;

/**
 * A double of ARIA's part for lasers: a laser that measures 2 m to the right and to the left, 1.5 m ahead, one ignored
 * reading, and nothing within its reach on the far left, every 150 ms.
 */
final class AriaLaserDouble {
    private static final long PERIOD_MS = 150;
    private static final int READINGS = 181;
    private static final int IGNORED = 30;
    private static final long REACH_MM = 8000;

    /** What was called, without getters. */
    final List<String> calls = new CopyOnWriteArrayList<>();

    volatile boolean reached = true;
    volatile boolean missing;
    volatile boolean silent;
    volatile Runnable delay = () -> {};
    volatile @Nullable Error error;

    private final List<Taken> taken = new CopyOnWriteArrayList<>(List.of(new Taken(0, 0)));
    private final Map<Long, ArTime> times = new ConcurrentHashMap<>();
    private volatile boolean connected;
    private volatile boolean there;
    private volatile long nowMs;

    /** When a scan was measured, and where the robot was. */
    record Taken(long ms, double xMm) {}

    void add() {
        there = true;
    }

    List<Taken> taken() {
        return List.copyOf(taken);
    }

    void step(long ms, RampModel model) {
        nowMs = ms;
        if (ms % PERIOD_MS == 0 && !silent) {
            taken.add(new Taken(ms, model.x()));
        }
    }

    private Taken last() {
        return taken.get(taken.size() - 1);
    }

    /** What MAJIC has of it. */
    AriaLaser of(ArRobot robot) {
        return new AriaLaser(robot) {
            @Override
            ArLaserConnector makeConnector() {
                return connector();
            }
        };
    }

    private ArLaserConnector connector() {
        if (missing) {
            throw new NoClassDefFoundError("com/mobilerobots/Aria/ArLaserConnector");
        }
        calls.add("new ArLaserConnector");
        ArLaser laser = laser();
        ArLaserConnector connector = mock();
        when(connector.connectLasers()).thenAnswer(call -> {
            calls.add("connectLasers");
            delay.run();
            connected = there && reached;
            return reached;
        });
        when(connector.getLaser(1)).thenAnswer(call -> there ? laser : null);
        return connector;
    }

    private ArLaser laser() {
        ArLaser laser = mock();
        ArSensorReadingVector readings = readings();
        when(laser.isConnected()).thenAnswer(call -> connected);
        when(laser.disconnect()).thenAnswer(call -> {
            calls.add("disconnect");
            connected = false;
            return true;
        });
        when(laser.getMaxRange()).thenReturn(REACH_MM);
        when(laser.getLastReadingTime()).thenAnswer(call -> time(last().ms()));
        when(laser.getRawReadingsAsVector()).thenAnswer(call -> {
            Error thrown = error;
            if (thrown != null) {
                throw thrown;
            }
            return readings;
        });
        return laser;
    }

    private ArTime time(long ms) {
        return times.computeIfAbsent(ms, key -> {
            ArTime time = mock();
            when(time.mSecSince()).thenAnswer(call -> (int) (nowMs - ms));
            when(time.isAt(any())).thenAnswer(call -> call.getArgument(0) == time);
            return time;
        });
    }

    private ArSensorReadingVector readings() {
        List<ArSensorReading> all = new ArrayList<>();
        for (int index = 0; index < READINGS; index++) {
            all.add(reading(index));
        }
        ArSensorReadingVector vector = mock();
        when(vector.size()).thenReturn((long) READINGS);
        when(vector.get(anyInt())).thenAnswer(call -> all.get(call.<Integer>getArgument(0)));
        return vector;
    }

    private ArSensorReading reading(int index) {
        double deg = index - 90;
        double range = index >= 150 ? REACH_MM + 1 : index >= 60 && index < 120 ? 1500 : 2000;
        ArSensorReading reading = mock();
        when(reading.getSensorX()).thenReturn(21.0);
        when(reading.getSensorTh()).thenReturn(deg);
        when(reading.getLocalX()).thenReturn(21 + range * Math.cos(Math.toRadians(deg)));
        when(reading.getLocalY()).thenReturn(range * Math.sin(Math.toRadians(deg)));
        when(reading.getIgnoreThisReading()).thenReturn(index == IGNORED || range > REACH_MM);
        when(reading.getTimeTaken()).thenAnswer(call -> time(last().ms()));
        when(reading.getXTaken()).thenAnswer(call -> last().xMm());
        return reading;
    }
}
