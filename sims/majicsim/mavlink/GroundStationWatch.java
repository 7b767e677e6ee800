package majicsim.mavlink;

/** How long the own ground station has been silent. One that was never there is not missed (sheet 9). */
final class GroundStationWatch {
    private double silentS = Double.NaN;

    void heard() {
        silentS = 0;
    }

    void step(double seconds) {
        silentS += seconds;
    }

    void restart() {
        silentS = Double.NaN;
    }

    /** Whether it was there, and has been silent for longer. */
    boolean isSilentFor(double seconds) {
        return silentS > seconds;
    }
}
