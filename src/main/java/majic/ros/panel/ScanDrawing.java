package majic.ros.panel;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import majic.panel.DrawingColors;

/**
 * The area that a scan has seen: a triangle between each two neighbouring beams with an echo. Where a beam has no echo
 * nothing is known, so nothing is filled.
 */
final class ScanDrawing {
    private static final double OPACITY = 0.14;

    private ScanDrawing() {}

    /** Paints in the robot's frame, mm. */
    static void paintSeen(Graphics2D pen, ScanEchoes scan, DrawingColors colors) {
        Path2D seen = new Path2D.Double();
        int beams = scan.beams();
        for (int beam = 0; beam < beams; beam++) {
            int next = (beam + 1) % beams;
            if (scan.hasEcho(beam) && scan.hasEcho(next) && isNarrow(scan, beam, next)) {
                seen.moveTo(0, 0);
                seen.lineTo(scan.xMm(beam), scan.yMm(beam));
                seen.lineTo(scan.xMm(next), scan.yMm(next));
                seen.closePath();
            }
        }
        pen.setColor(colors.wash(OPACITY));
        pen.fill(seen);
    }

    /** The last and the first beam are neighbours only in a scan of a full turn. */
    private static boolean isNarrow(ScanEchoes scan, int one, int other) {
        double from = Math.atan2(scan.yMm(one), scan.xMm(one));
        double to = Math.atan2(scan.yMm(other), scan.xMm(other));
        return Math.abs(Math.IEEEremainder(to - from, 2 * Math.PI)) < Math.PI / 6;
    }
}
