package majicsim.pioneer.devices;

/**
 * The speed of the serial port to the client: HOSTBAUD changes it at once, and it falls back when no valid packet
 * follows within 500 ms (ARCOS sheet 6.1).
 */
public final class HostBaud {
    private static final int[] BITS_PER_SECOND = {9600, 19_200, 38_400, 57_600, 115_200};
    private static final long TRIAL_NANOS = 500_000_000L;

    private int code;
    private int former;
    private long trialNanos;

    /** The speed that a code 0 to 4 stands for; 9600 for any other. */
    static int bitsPerSecond(int code) {
        return isCode(code) ? BITS_PER_SECOND[code] : BITS_PER_SECOND[0];
    }

    /** Whether it stands for a speed. */
    static boolean isCode(int code) {
        return code >= 0 && code < BITS_PER_SECOND.length;
    }

    /** HOSTBAUD; anything but 0 to 4 is ignored. */
    public void change(int newCode) {
        if (isCode(newCode) && newCode != code) {
            former = code;
            code = newCode;
            trialNanos = TRIAL_NANOS;
        }
    }

    /** Reports a valid packet: this speed is right. */
    public void confirm() {
        trialNanos = 0;
    }

    /** The stored speed, as at power-up. */
    void restore() {
        code = 0;
        trialNanos = 0;
    }

    /** Whether the speed may still fall back. */
    boolean isOnTrial() {
        return trialNanos > 0;
    }

    void step(long nanos) {
        if (trialNanos > 0) {
            trialNanos -= nanos;
            if (trialNanos <= 0) {
                code = former;
            }
        }
    }

    /** 0 to 4, as CONFIG shows it. */
    public int code() {
        return code;
    }

    public int bitsPerSecond() {
        return bitsPerSecond(code);
    }
}
