package majicsim.pioneer.devices;

/**
 * The charger and the docking mechanism that takes its power (ARCOS sheet 6.1 CHARGE, 8 CHARGESTATE). A model without
 * the mechanism charges by a plug that its controller does not sense.
 */
public final class Charger {
    static final int NOT_CHARGING = 0;
    static final int BULK = 1;
    static final int OVERCHARGE = 2;
    static final int FLOAT = 3;

    private static final double BULK_AMPERES = 6;
    private static final double BULK_TO = 0.9;
    private static final double FULL = 0.999;

    private final boolean fitted;
    private final Battery battery;
    private boolean powered;
    private boolean deployed = true;

    Charger(boolean fitted, Battery battery) {
        this.fitted = fitted;
        this.battery = battery;
    }

    /** Sets whether the robot is at its charging station, or plugged in. */
    public void power(boolean on) {
        powered = on;
    }

    /** CHARGE: puts out or takes back the mechanism. */
    public void deploy(boolean out) {
        deployed = out;
    }

    /** FLAGS bit 10. */
    public boolean isPowerGood() {
        return fitted && isCharging();
    }

    /** As CHARGESTATE reports it. */
    public int state() {
        if (!isPowerGood()) {
            return NOT_CHARGING;
        }
        if (battery.charge() < BULK_TO) {
            return BULK;
        }
        return battery.charge() < FULL ? OVERCHARGE : FLOAT;
    }

    /** The present charging current, which decreases towards the end. */
    double amperes() {
        if (!isCharging()) {
            return 0;
        }
        return battery.charge() < BULK_TO ? BULK_AMPERES : BULK_AMPERES / 3;
    }

    private boolean isCharging() {
        return powered && (deployed || !fitted);
    }
}
