package majic.aibo.body;

import java.util.Optional;
import java.util.stream.Stream;

/** The three distance sensors, from the dog's centimetres to what they mean (URBI sheet 13). */
public final class InfraRed {
    /** A reading this close to the end of a sensor's range means that it sees nothing. */
    private static final double END_CM = 0.5;

    private static final double NEAR_END_CM = 50;
    private static final double FAR_END_CM = 150;
    private static final double CHEST_END_CM = 90;
    private static final double MM_PER_CM = 10;

    /** The chest sensor may see the floor; only what is clearly nearer than that is something in the way. */
    private static final double NEARER_THAN_FLOOR = 0.85;

    private final SensorReadings senses;
    private volatile double floorCm = Double.NaN;

    InfraRed(SensorReadings senses) {
        this.senses = senses;
    }

    /** What a sensor sees, mm from the sensor; empty if nothing is in its range or it has not been read. */
    public Optional<Double> rangeMm(Sensor sensor) {
        double endCm = switch (sensor) {
            case NEAR -> NEAR_END_CM;
            case FAR -> FAR_END_CM;
            case CHEST -> CHEST_END_CM;
            default -> 0;
        };
        return senses.number(sensor).filter(cm -> cm < endCm - END_CM).map(cm -> Math.max(0, cm) * MM_PER_CM);
    }

    /** What the two sensors in the head see where it looks, mm; the nearer of both counts. */
    public Optional<Double> headMm() {
        return Stream.of(rangeMm(Sensor.NEAR), rangeMm(Sensor.FAR))
                .flatMap(Optional::stream)
                .min(Double::compare);
    }

    /** What the chest sees that cannot be the floor, mm; nothing before the dog has stood. */
    public Optional<Double> chestMm() {
        double floor = floorCm;
        return rangeMm(Sensor.CHEST).filter(mm -> mm < NEARER_THAN_FLOOR * floor * MM_PER_CM);
    }

    /** The dog has just come to its feet: what its chest sees now may be the floor. */
    void standing() {
        floorCm = senses.number(Sensor.CHEST).orElse(Double.NaN);
    }

    /** Whether the head's sensors have reported anything yet. */
    public boolean isKnown() {
        return senses.number(Sensor.NEAR).isPresent()
                || senses.number(Sensor.FAR).isPresent();
    }

    /** What the chest saw when the dog came to its feet, cm; NaN before. */
    double floorCm() {
        return floorCm;
    }

    void setFloorCm(double cm) {
        floorCm = cm;
    }
}
