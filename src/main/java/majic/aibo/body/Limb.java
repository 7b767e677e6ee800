package majic.aibo.body;

/** The four legs: where they join the body, and the sensors of their joints and paws. */
public enum Limb {
    LEFT_FORE(1, 1, Sensor.LEG_LF1, Sensor.LEG_LF2, Sensor.LEG_LF3, Sensor.PAW_LF),
    RIGHT_FORE(1, -1, Sensor.LEG_RF1, Sensor.LEG_RF2, Sensor.LEG_RF3, Sensor.PAW_RF),
    LEFT_HIND(-1, 1, Sensor.LEG_LH1, Sensor.LEG_LH2, Sensor.LEG_LH3, Sensor.PAW_LH),
    RIGHT_HIND(-1, -1, Sensor.LEG_RH1, Sensor.LEG_RH2, Sensor.LEG_RH3, Sensor.PAW_RH);

    private static final double HALF_LENGTH_MM = 65;
    private static final double HALF_WIDTH_MM = 62;
    private static final BodyPoint THIGH = new BodyPoint(0, 0, -70);
    private static final BodyPoint SHANK = new BodyPoint(0, 0, -74);

    private final int ahead;
    private final int left;
    private final Sensor swing;
    private final Sensor spread;
    private final Sensor knee;
    private final Sensor paw;

    Limb(int ahead, int left, Sensor swing, Sensor spread, Sensor knee, Sensor paw) {
        this.ahead = ahead;
        this.left = left;
        this.swing = swing;
        this.spread = spread;
        this.knee = knee;
        this.paw = paw;
    }

    /** What feels the ground. */
    public Sensor paw() {
        return paw;
    }

    /**
     * A leg's bones.
     *
     * @param top where it joins the body
     * @param middle elbow or knee
     * @param foot its lowest joint
     */
    public record Bones(BodyPoint top, BodyPoint middle, BodyPoint foot) {}

    /**
     * Where the bones are, in the body's frame. Fore legs bend their elbows to the rear, hind legs their knees ahead.
     */
    Bones bones(SensorReadings senses) {
        double swingDeg = ahead * senses.number(swing).orElse(fore() ? -20.0 : -25.0);
        double spreadDeg = left * senses.number(spread).orElse(fore() ? 25.0 : 10.0);
        double kneeDeg = ahead * senses.number(knee).orElse(fore() ? 90.0 : 80.0);
        BodyPoint top = new BodyPoint(ahead * HALF_LENGTH_MM, left * HALF_WIDTH_MM, 0);
        BodyPoint middle = top.plus(THIGH.spread(spreadDeg).raised(swingDeg));
        BodyPoint foot = middle.plus(SHANK.raised(kneeDeg).spread(spreadDeg).raised(swingDeg));
        return new Bones(top, middle, foot);
    }

    private boolean fore() {
        return ahead > 0;
    }
}
