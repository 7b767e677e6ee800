package majicsim.mavlink;

/** A battery of three lithium cells: voltage falls evenly with the charge, and with the current. */
final class Battery {
    private static final double FULL_V = 12.6;
    private static final double EMPTY_V = 10.2;
    private static final double RESISTANCE_OHM = 0.01;
    private static final double SECONDS_AN_HOUR = 3600;
    private static final int OK = 1;
    private static final int LOW = 2;

    private final Parameters parameters;
    private final Announcements announcements;
    private double usedMah;
    private double usedJ;
    private double amperes;
    private boolean isLow;

    Battery(Parameters parameters, Announcements announcements) {
        this.parameters = parameters;
        this.announcements = announcements;
    }

    void step(double newAmperes, double seconds) {
        amperes = newAmperes;
        usedMah = Math.min(capacityMah(), usedMah + amperes * seconds / SECONDS_AN_HOUR * 1000);
        usedJ += amperes * volts() * seconds;
        boolean low = volts() < parameters.get("BATT_LOW_VOLT");
        if (low && !isLow) {
            announcements.say(
                    Announcements.WARNING, "Battery 1 is low " + tenths(volts()) + "V used " + (int) usedMah + " mAh");
        }
        isLow = low;
    }

    private static String tenths(double volts) {
        return String.valueOf(Math.round(volts * 10) / 10.0);
    }

    /** Sets the charge. */
    void charge(double percent) {
        usedMah = capacityMah() * (1 - percent / 100);
    }

    private double capacityMah() {
        return parameters.get("BATT_CAPACITY");
    }

    double volts() {
        return EMPTY_V + (FULL_V - EMPTY_V) * (1 - usedMah / capacityMah()) - amperes * RESISTANCE_OHM;
    }

    double amperes() {
        return amperes;
    }

    double usedMah() {
        return usedMah;
    }

    double usedJ() {
        return usedJ;
    }

    long percent() {
        return Math.round(100 * (1 - usedMah / capacityMah()));
    }

    /** As in BATTERY_STATUS. */
    int chargeState() {
        return isLow ? LOW : OK;
    }
}
