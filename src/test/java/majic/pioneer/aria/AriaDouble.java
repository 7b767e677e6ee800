package majic.pioneer.aria;

import static org.mockito.Mockito.RETURNS_DEFAULTS;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import com.mobilerobots.Aria.ArDeviceConnection;
import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArSensorReading;
import com.mobilerobots.Aria.ArTime;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import majic.drivertest.TestClock;
import majic.pioneer.session.RampModel;
import org.jspecify.annotations.Nullable;
import org.mockito.invocation.InvocationOnMock;
import org.mockito.stubbing.Answer;

/**
 * A double of ARIA with a robot behind it, on a stepped clock. Its getters show the last SIP of the robot, and
 * velocities are sent in its own cycle, as ARIA does it. Calls without the lock, and time that passes while the lock is
 * held, are noted as violations.
 */
final class AriaDouble implements Answer<Object>, AutoCloseable {
    private static final long CYCLE_MS = 100;
    private static final int SONARS_ON = 0x1E;

    /** What was called, without getters: {@code "setVel 300.0"}. */
    final List<String> calls = new CopyOnWriteArrayList<>();

    final List<String> violations = new CopyOnWriteArrayList<>();
    final RampModel model = new RampModel(300, 500, 100);
    final ArRobot robot = mock(ArRobot.class, this);
    final ArDeviceConnection device = mock();
    final AriaLaserDouble laser = new AriaLaserDouble();

    /** Answers in place of those below. */
    final Map<String, Supplier<Object>> others = new HashMap<>();

    volatile boolean silent;
    volatile boolean connected;

    private final ArTime lastSip = mock();
    private final ArSensorReading sonar = mock();
    private final ArRobot.ChargeState notCharging = mock();
    private final TestClock clock;
    private final long phaseMs;
    private final List<Runnable> inNextCycle = new ArrayList<>();
    private Map<String, Object> shown = new HashMap<>();
    private boolean motors;
    private int locks;
    private long lockedAtMs;
    private long ms;
    private long sipMs;
    private long sips;

    /**
     * Creates a robot that is not connected.
     *
     * @param phaseMs from a SIP to the cycle in which velocities are sent, 0 to 99
     */
    AriaDouble(long phaseMs) {
        this.phaseMs = phaseMs;
        when(lastSip.mSecSince()).thenAnswer(call -> (int) (ms - sipMs));
        when(sonar.getCounterTaken()).thenAnswer(call -> sips);
        takeSip();
        clock = new TestClock(nanos -> step(), () -> true);
    }

    TestClock clock() {
        return clock;
    }

    private synchronized void step() {
        ms++;
        model.step(0.001);
        if (ms % CYCLE_MS == 0 && !silent) {
            takeSip();
        }
        laser.step(ms, model);
        if (ms % CYCLE_MS == phaseMs) {
            inNextCycle.forEach(Runnable::run);
            inNextCycle.clear();
        }
    }

    private void takeSip() {
        sips++;
        sipMs = ms;
        double difference = Math.toRadians(model.rate()) / 0.0056;
        shown = Map.of(
                "getX", model.x(),
                "getY", model.y(),
                "getTh", Math.IEEEremainder(model.heading(), 360),
                "getLeftVel", model.speed() - difference,
                "getRightVel", model.speed() + difference,
                "getRotVel", model.rate(),
                "getFlags", SONARS_ON | (motors ? 1 : 0));
    }

    @Override
    public Object answer(InvocationOnMock call) throws Throwable {
        Supplier<Object> other = others.get(call.getMethod().getName());
        return other == null ? usual(call) : other.get();
    }

    private synchronized Object usual(InvocationOnMock call) throws Throwable {
        String name = call.getMethod().getName();
        return switch (name) {
            case "tryLock" -> lock();
            case "unlock" -> unlock();
            case "blockingConnect" -> connect();
            case "setDeviceConnection", "runAsync", "stopRunning" -> lifecycle(name);
            case "toString", "hashCode", "equals" -> RETURNS_DEFAULTS.answer(call);
            default -> locked(name, call);
        };
    }

    private int lock() {
        lockedAtMs = locks++ == 0 ? ms : lockedAtMs;
        return 0;
    }

    private int unlock() {
        locks--;
        if (ms != lockedAtMs) {
            violations.add("the lock was held for " + (ms - lockedAtMs) + " ms");
        }
        return 0;
    }

    private boolean connect() {
        calls.add("blockingConnect");
        connected = true;
        return true;
    }

    private Object lifecycle(String name) {
        calls.add(name);
        connected &= !name.equals("stopRunning");
        return null;
    }

    private Object locked(String name, InvocationOnMock call) throws Throwable {
        if (locks == 0) {
            violations.add(name + " without the lock");
        }
        Object value = shown.get(name);
        if (value != null) {
            return value;
        }
        return switch (name) {
            case "isConnected" -> connected;
            case "getLastOdometryTime" -> lastSip;
            case "getSonarReading" -> sonar;
            case "getNumSonar" -> 16;
            case "getSonarRange" -> 5000;
            case "getChargeState" -> notCharging;
            case "getRobotName" -> "Rosa";
            case "getRobotType" -> "Pioneer";
            case "getRobotSubType" -> "p3dx-sh";
            case "getBatteryVoltageNow", "getRealBatteryVoltageNow" -> 12.5;
            case "com", "comInt", "com2Bytes", "comStrN" -> command(name, call);
            default -> isCommand(call) ? command(name, call) : RETURNS_DEFAULTS.answer(call);
        };
    }

    private static boolean isCommand(InvocationOnMock call) {
        return call.getMethod().getReturnType() == void.class;
    }

    private @Nullable Object command(String name, InvocationOnMock call) {
        StringBuilder text = new StringBuilder(name);
        for (Object argument : call.getArguments()) {
            text.append(' ').append(argument);
        }
        calls.add(text.toString());
        switch (name) {
            case "setVel" -> later(() -> model.speed((int) Math.round(call.<Double>getArgument(0))));
            case "setRotVel" -> later(() -> model.rate((int) Math.round(call.<Double>getArgument(0))));
            case "stop" -> stop();
            case "enableMotors" -> motors = true;
            case "disableMotors" -> motors = false;
            default -> {}
        }
        return isCommand(call) ? null : true;
    }

    private void later(Runnable velocity) {
        inNextCycle.add(velocity);
    }

    /** ARIA sends it at once. */
    private void stop() {
        inNextCycle.clear();
        model.speed(0);
        model.rate(0);
    }

    @Override
    public void close() {
        clock.close();
    }
}
