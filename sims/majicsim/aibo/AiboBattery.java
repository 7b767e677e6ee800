package majicsim.aibo;

/** The charge of the dog's battery, which lasts an hour and a half. */
final class AiboBattery {
    private static final double FIRST = 0.878;
    private static final double LASTS_SEC = 5400;

    private double charge = FIRST;

    int percent() {
        return (int) Math.floor(charge * 100 + 1e-9);
    }

    /** Whether it is empty; then nothing in the dog runs. */
    boolean isEmpty() {
        return charge <= 0;
    }

    /** Replaces the battery. */
    void replace(double newCharge) {
        charge = newCharge;
    }

    void drain(double seconds) {
        charge = Math.max(0, charge - seconds / LASTS_SEC);
    }
}
