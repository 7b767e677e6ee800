package majicsim.aibo.body;

/** The orientation of the dog's body, from its legs and from being turned over. */
public final class BodyOrientation {
    private static final double ON_ITS_SIDE_DEG = 45;
    private static final double ON_ITS_BACK_DEG = 135;

    private final Legs legs;
    private double rollDeg;

    public BodyOrientation(Legs legs) {
        this.legs = legs;
    }

    ShoulderPose shoulders() {
        return legs.shoulders();
    }

    /** 0 on its feet, 90 lying on its right side, 180 on its back. */
    double rollDeg() {
        return rollDeg;
    }

    public void roll(double degrees) {
        rollDeg = degrees;
    }

    boolean isUpright() {
        return Math.abs(Math.IEEEremainder(rollDeg, 360)) < ON_ITS_SIDE_DEG;
    }

    /** Whether a leg, such as LF, is on the floor: true unless a gait bends its knee to lift it. */
    boolean isOnGround(String leg) {
        return guess().equals("stand") && !legs.isLifted(leg);
    }

    /** The posture's name as MyguessPosition reports it (URBI sheet, section 15). */
    public String guess() {
        if (isUpright()) {
            return legs.guess();
        }
        return Math.abs(Math.IEEEremainder(rollDeg, 360)) < ON_ITS_BACK_DEG ? "side" : "back";
    }
}
