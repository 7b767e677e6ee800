package majic.aibo;

import org.jspecify.annotations.Nullable;

/** How the dog's body is drawn from the side; lengths in mm, x ahead, y up from the ground. */
enum Stance {
    STAND(-95, 130, 0, 78, -100),
    SIT(-55, 52, 40, 115, 20),
    LAY(-95, 52, 0, 150, -25);

    private final double hipMm;
    private final double hipHeightMm;
    private final double pitchDeg;
    private final double forePawMm;
    private final double hindPawMm;

    Stance(double hipMm, double hipHeightMm, double pitchDeg, double forePawMm, double hindPawMm) {
        this.hipMm = hipMm;
        this.hipHeightMm = hipHeightMm;
        this.pitchDeg = pitchDeg;
        this.forePawMm = forePawMm;
        this.hindPawMm = hindPawMm;
    }

    /** What comes nearest to what the dog takes its posture for. */
    static Stance of(@Nullable String posture) {
        if ("sit".equals(posture) || "beg".equals(posture)) {
            return SIT;
        }
        return "lay".equals(posture) || "side".equals(posture) || "back".equals(posture) ? LAY : STAND;
    }

    double hipMm() {
        return hipMm;
    }

    double hipHeightMm() {
        return hipHeightMm;
    }

    double pitchDeg() {
        return pitchDeg;
    }

    double forePawMm() {
        return forePawMm;
    }

    double hindPawMm() {
        return hindPawMm;
    }
}
