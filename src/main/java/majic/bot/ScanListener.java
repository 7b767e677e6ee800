package majic.bot;

/**
 * Receives what the range sensors of a robot measure. Called on the robot's listener thread, one scan after the other;
 * one that blocks holds up the robot's other listeners, but no stop and nothing the robot reports.
 */
@FunctionalInterface
public interface ScanListener {
    /**
     * A sensor has measured.
     *
     * @param scan of one of {@link MajicBot#rangeSensors()}; its time is that of {@link MajicBot#time()}
     */
    void scanned(RangeScan scan);
}
