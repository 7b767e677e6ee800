package majicsim.pioneer.devices;

/**
 * Three lead-acid batteries of 7.2 Ah: 13.0 V full, 11.0 V empty, falling evenly in between as charge is drawn. BATTEST
 * can report another voltage, also after the session (ARCOS sheet 5.1).
 */
public final class Battery {
    private static final double CAPACITY_AMPERE_SECONDS = 21.6 * 3600;
    private static final double EMPTY_VOLTS = 11;
    private static final double FULL_VOLTS = 13;

    private double charge = 1;
    private int pretendedTenthVolts;

    /** Draws this current, or charges with it if negative. */
    void step(double seconds, double amperes) {
        charge = Math.max(0, Math.min(1, charge - amperes * seconds / CAPACITY_AMPERE_SECONDS));
    }

    /** BATTEST: reports this voltage in 0.1 V; 0 returns to the real one. */
    public void pretend(int tenthVolts) {
        pretendedTenthVolts = Math.max(0, tenthVolts);
    }

    boolean isPretended() {
        return pretendedTenthVolts > 0;
    }

    public int tenthVolts() {
        return isPretended() ? pretendedTenthVolts : (int) Math.round(restingVolts() * 10);
    }

    /** 0 to 1. */
    double charge() {
        return charge;
    }

    /** In percent as far as the voltage shows it, 1 to 100, since 0 means unknown. */
    public int percent() {
        double shown = isPretended() ? (pretendedTenthVolts / 10.0 - EMPTY_VOLTS) / (FULL_VOLTS - EMPTY_VOLTS) : charge;
        return (int) Math.round(Math.max(1, Math.min(100, shown * 100)));
    }

    private double restingVolts() {
        return EMPTY_VOLTS + charge * (FULL_VOLTS - EMPTY_VOLTS);
    }
}
