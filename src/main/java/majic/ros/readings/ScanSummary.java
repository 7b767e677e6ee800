package majic.ros.readings;

import java.util.Arrays;
import java.util.List;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * A scan in short: the nearest echo in each of twelve sectors of 30 degrees. The first sector is centred ahead, the
 * others follow counterclockwise. Distances count from the turning centre of the robot. Immutable.
 */
public final class ScanSummary {
    /** How many sectors there are. */
    static final int COUNT = 12;

    private static final double WIDTH_DEG = 360.0 / COUNT;
    private static final Value NO_ECHO = Value.unknown("no echo");

    private final double[] sectorsMm;
    private final int nearestBeam;

    private ScanSummary(double[] sectorsMm, int nearestBeam) {
        this.sectorsMm = sectorsMm;
        this.nearestBeam = nearestBeam;
    }

    /**
     * Summarises a scan.
     *
     * @param scan any
     * @return its sectors
     */
    public static ScanSummary of(ScanPoints scan) {
        double[] sectors = new double[COUNT];
        Arrays.fill(sectors, Double.POSITIVE_INFINITY);
        int nearest = -1;
        double nearestMm = Double.POSITIVE_INFINITY;
        for (int beam = 0; beam < scan.beams(); beam++) {
            if (scan.hasEcho(beam)) {
                double distance = distanceMm(scan, beam);
                int sector = sector(bearingDeg(scan, beam));
                sectors[sector] = Math.min(sectors[sector], distance);
                if (distance < nearestMm) {
                    nearest = beam;
                    nearestMm = distance;
                }
            }
        }
        return new ScanSummary(sectors, nearest);
    }

    private static int sector(double bearingDeg) {
        return (int) Math.floor((bearingDeg + 360 + WIDTH_DEG / 2) / WIDTH_DEG) % COUNT;
    }

    private static double distanceMm(ScanPoints scan, int beam) {
        return Math.hypot(scan.xMm(beam), scan.yMm(beam));
    }

    private static double bearingDeg(ScanPoints scan, int beam) {
        return Math.toDegrees(Math.atan2(scan.yMm(beam), scan.xMm(beam)));
    }

    /**
     * Returns the nearest echo of each sector.
     *
     * @return twelve values in mm; unknown without an echo
     */
    public Value values() {
        List<Value> values = Arrays.stream(sectorsMm)
                .mapToObj(mm -> Double.isFinite(mm) ? Value.of(Math.round(mm), Unit.MM) : NO_ECHO)
                .toList();
        return Value.many(values);
    }

    /**
     * Returns the distance of the nearest echo.
     *
     * @param scan the same scan
     * @return mm; unknown without any echo
     */
    public Value nearestMm(ScanPoints scan) {
        return nearestBeam < 0 ? NO_ECHO : Value.of(Math.round(distanceMm(scan, nearestBeam)), Unit.MM);
    }

    /**
     * Returns the direction of the nearest echo.
     *
     * @param scan the same scan
     * @return degrees, counterclockwise positive; unknown without any echo
     */
    public Value bearing(ScanPoints scan) {
        return nearestBeam < 0 ? NO_ECHO : Value.of(bearingDeg(scan, nearestBeam), Unit.DEG);
    }
}
