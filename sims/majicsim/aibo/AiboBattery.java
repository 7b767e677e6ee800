package majicsim.aibo;

/** The charge of the dog: an hour and a half from full to empty. */
final class AiboBattery {
    private static final double FIRST = 0.878;
    private static final double LASTS_SEC = 5400;

    private double charge = FIRST;

    int percent() {
        return (int) Math.floor(charge * 100 + 1e-9);
    }

    /** Once it is empty, nothing in the dog runs. */
    boolean isEmpty() {
        return charge <= 0;
    }

    /** Puts another one in. */
    void replace(double newCharge) {
        charge = newCharge;
    }

    void drain(double seconds) {
        charge = Math.max(0, charge - seconds / LASTS_SEC);
    }
}
