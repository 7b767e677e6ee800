package majic.pioneer.state;

import java.util.List;

/**
 * The robot's outline, a box around its turning centre. Immutable.
 *
 * @param frontMm from the turning centre to the front, mm
 * @param rearMm from the turning centre to the rear, mm, positive
 * @param halfWidthMm from the turning centre to either side, mm
 */
public record Hull(double frontMm, double rearMm, double halfWidthMm) {

    /**
     * A hull of known length, placed by the sonar arrays: it protrudes by the same length in front of them and behind.
     * For a P3-DX that gives the 210 and 301 mm of ARCOS sheet 12.
     */
    static Hull around(List<SonarDisc> discs, double lengthMm, double widthMm) {
        double front = discs.stream().mapToDouble(SonarDisc::xMm).max().orElse(0);
        double rear = discs.stream().mapToDouble(SonarDisc::xMm).min().orElse(0);
        double over = Math.max(0, (lengthMm - (front - rear)) / 2);
        return new Hull(front + over, over - rear, widthMm / 2);
    }

    /** Radius of the circle that the robot needs to turn on the spot, mm. */
    public double swingMm() {
        // Not Math.hypot, which takes many times as long: this is used for each echo at each SIP.
        double end = Math.max(frontMm, rearMm);
        return Math.sqrt(end * end + halfWidthMm * halfWidthMm);
    }
}
