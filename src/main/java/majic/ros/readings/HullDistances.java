package majic.ros.readings;

import java.util.List;
import java.util.Optional;
import majic.bot.Unit;
import majic.bot.Value;
import majic.ros.message.FrameTransform;
import majic.ros.message.RangeMessage;
import majic.ros.message.Vector;

/**
 * The distance from the hull on one side, from a scan and from single beams. Immutable.
 *
 * <p>The nearest echo in the way counts. Without one the way is free only as far as it was seen: beams without an echo
 * may be free, but also blocked by something black, shiny or too near (REP-117, and rosbridge sends all of these as
 * {@code null}). So a gap of such beams that is wider than {@link #WIDEST_GAP_DEG} makes the distance unknown. There
 * are two exceptions: the user has set that no echo means that nothing is there, or what is too near for the scanner
 * would touch the hull, so that only something black or shiny can hide, as it can from every scanner and sonar.
 *
 * @param radiusMm of the hull
 * @param noEcho what it means that a beam has none
 */
record HullDistances(double radiusMm, NoEcho noEcho) {
    /** A few beams without an echo are usual in every scan. */
    static final double WIDEST_GAP_DEG = 10;

    /** How near to the hull something is that touches it soon, mm. */
    private static final double TOUCHING_MM = 50;

    /** A scanner that hardly sees anything may be defective or covered. */
    private static final double LEAST_ECHOES = 0.05;

    /** Scanners leave out a beam or two between the last one and the first. */
    private static final double WHOLE_TURN_DEG = 350;

    private static final Value NO_ECHO = Value.unknown("no echo there: free, or too near, black or shiny");
    private static final Value NOT_SEEN = Value.unknown("no sensor looks there");

    /** A sensor with a single beam, and where it is on the robot. */
    record Beam(RangeMessage reading, FrameTransform sensor) {
        double directionDeg() {
            Vector along = sensor.orientation().rotate(new Vector(1, 0, 0));
            return Math.toDegrees(Math.atan2(along.y(), along.x()));
        }

        Vector pointMm() {
            return sensor.apply(new Vector(reading.rangeMm().orElse(Double.NaN), 0, 0));
        }
    }

    /**
     * Returns the distance.
     *
     * @param side where
     * @param scan the newest scan; empty without a scanner or a recent reading
     * @param beams the newest readings of the single beams
     * @return mm, clear, or unknown with the reason
     */
    Value distance(HullSide side, Optional<ScanPoints> scan, List<Beam> beams) {
        List<Beam> here = beams.stream()
                .filter(beam -> side.isSeenIn(beam.directionDeg()))
                .toList();
        double nearest = Math.min(
                scan.map(points -> nearestMm(side, points)).orElse(Double.POSITIVE_INFINITY), nearestMm(side, here));
        if (Double.isFinite(nearest)) {
            return Value.of(Math.round(nearest), Unit.MM);
        }
        boolean scanned = scan.filter(points -> sees(side, points)).isPresent();
        if (!scanned && here.isEmpty()) {
            return NOT_SEEN;
        }
        boolean seen = noEcho == NoEcho.CLEAR
                || scanned && isSeen(side, scan.get())
                || here.stream().anyMatch(beam -> beam.reading().rangeMm().isPresent());
        return seen ? Value.CLEAR : NO_ECHO;
    }

    private boolean isSeen(HullSide side, ScanPoints scan) {
        return noEcho == NoEcho.AUTO && hidesNothing(side, scan) || widestGapDeg(side, scan) <= WIDEST_GAP_DEG;
    }

    private boolean hidesNothing(HullSide side, ScanPoints scan) {
        return scan.echoes() >= LEAST_ECHOES * scan.beams()
                && scan.leastMm() - side.toHullMm(radiusMm, scan.originMm()) <= TOUCHING_MM;
    }

    private double nearestMm(HullSide side, ScanPoints scan) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int beam = 0; beam < scan.beams(); beam++) {
            if (scan.hasEcho(beam)) {
                nearest = Math.min(nearest, side.gapMm(radiusMm, scan.xMm(beam), scan.yMm(beam)));
            }
        }
        return nearest;
    }

    private double nearestMm(HullSide side, List<Beam> beams) {
        return beams.stream()
                .filter(beam -> beam.reading().rangeMm().isPresent())
                .map(Beam::pointMm)
                .mapToDouble(point -> side.gapMm(radiusMm, point.x(), point.y()))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    private static boolean sees(HullSide side, ScanPoints scan) {
        for (int beam = 0; beam < scan.beams(); beam++) {
            if (side.isSeenIn(scan.directionDeg(beam))) {
                return true;
            }
        }
        return false;
    }

    /** The widest run of beams without an echo on a side. A scan of a full turn may begin in the middle of the side. */
    private static double widestGapDeg(HullSide side, ScanPoints scan) {
        boolean wholeTurn = scan.beams() * scan.stepDeg() > WHOLE_TURN_DEG;
        int run = 0;
        int longest = 0;
        for (int index = 0; index < (wholeTurn ? 2 : 1) * scan.beams(); index++) {
            int beam = index % scan.beams();
            run = side.isSeenIn(scan.directionDeg(beam)) && !scan.hasEcho(beam) ? run + 1 : 0;
            longest = Math.max(longest, run);
        }
        return longest * scan.stepDeg();
    }
}
