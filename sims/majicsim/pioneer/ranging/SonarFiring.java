package majicsim.pioneer.ranging;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.model.SonarDisc;
import org.jspecify.annotations.Nullable;

/**
 * Fires the discs: one of each array at a time, every 40 ms unless set otherwise, so that a SIP carries only the few
 * readings that are new (ARCOS sheet 8.2).
 */
public final class SonarFiring {
    private static final int ARRAYS = PollingOrder.ARRAYS;
    private static final int SLOTS = 8;
    private static final int USUAL_CYCLE_MS = 40;
    private static final long NANOS_PER_MS = 1_000_000;

    private final PioneerModel model;
    private final SonarCone cone;
    private final Map<Integer, Integer> fresh = new LinkedHashMap<>();
    private final @Nullable SonarDisc[] discs = new SonarDisc[SonarDisc.MOST];
    private List<List<Integer>> firing = PollingOrder.USUAL.ofArrays();
    private int arraysOn;
    private long cycleNanos;
    private long untilFiringNanos;
    private int turn;

    public SonarFiring(PioneerModel model, SonarCone cone) {
        this.model = model;
        this.cone = cone;
        model.sonars().forEach(disc -> discs[disc.number()] = disc);
        stop();
    }

    /** All arrays on, beginning with the first disc of each after one firing period. */
    public void start() {
        stop();
        arraysOn = (1 << ARRAYS) - 1;
    }

    public void stop() {
        arraysOn = 0;
        turn = 0;
        firing = PollingOrder.USUAL.ofArrays();
        fresh.clear();
        cycleMs(0);
        untilFiringNanos = cycleNanos;
    }

    /** SONAR: bit 0 on or off; the bits above choose one array, counted from 1, or all with 0. */
    public void switchArrays(int argument) {
        int array = argument >> 1;
        if (array < 0 || array > ARRAYS) {
            return;
        }
        int mask = array == 0 ? (1 << ARRAYS) - 1 : 1 << (array - 1);
        arraysOn = (argument & 1) == 1 ? arraysOn | mask : arraysOn & ~mask;
        fresh.keySet().removeIf(disc -> !isOn(disc / SLOTS));
    }

    /** POLLING: another firing order. */
    public void order(byte[] numbers) {
        firing = PollingOrder.of(numbers).ofArrays();
        turn = 0;
    }

    /** SONARCYCLE: the firing period in ms; 0 or less is the usual one. */
    public void cycleMs(int ms) {
        cycleNanos = (ms > 0 ? ms : USUAL_CYCLE_MS) * NANOS_PER_MS;
    }

    public int cycleMs() {
        return (int) (cycleNanos / NANOS_PER_MS);
    }

    /** Bit 0 for the first array. */
    public int arraysOn() {
        return arraysOn;
    }

    /** The time until the next firing, ns; without end if all arrays are off. */
    public long restNanos() {
        return arraysOn == 0 ? Long.MAX_VALUE : untilFiringNanos;
    }

    public void step(long nanos) {
        untilFiringNanos -= nanos;
        while (untilFiringNanos <= 0) {
            untilFiringNanos += cycleNanos;
            fire();
        }
    }

    /** The readings since the last call, in the order of firing. */
    public List<SonarReading> takeFresh() {
        List<SonarReading> readings = new ArrayList<>(fresh.size());
        for (Map.Entry<Integer, Integer> reading : fresh.entrySet()) {
            readings.add(new SonarReading(reading.getKey(), reading.getValue()));
        }
        fresh.clear();
        return readings;
    }

    private void fire() {
        for (int array = 0; array < ARRAYS; array++) {
            List<Integer> numbers = firing.get(array);
            if (isOn(array) && !numbers.isEmpty()) {
                fire(numbers.get(turn % numbers.size()));
            }
        }
        turn++;
    }

    private void fire(int number) {
        SonarDisc disc = discs[number];
        if (disc != null) {
            fresh.put(number, model.scaling().range(cone.rangeMm(disc)));
        }
    }

    private boolean isOn(int array) {
        return (arraysOn >> array & 1) == 1;
    }
}
