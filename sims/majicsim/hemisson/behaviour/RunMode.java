package majicsim.hemisson.behaviour;

import majicsim.hemisson.options.HemissonOptions;

/** What the firmware does besides answering; read from the switches at start-up (sheet 7). */
public enum RunMode {
    /** The serial line and the TV remote drive. */
    REMOTE,
    /** It drives and avoids obstacles. */
    AVOIDING,
    /** It follows black tape. */
    LINE,
    /** It swings to and fro. */
    DANCE,
    /** A BotStudio program from an EEPROM that is empty: speeds stay 0, whatever is commanded. */
    BOTSTUDIO,
    /** Any other setting: speeds stay 0, and the receiver is read so rarely that a longer command blocks it. */
    OTHER;

    static RunMode of(String switches) {
        return switch (switches) {
            case HemissonOptions.REMOTE_CONTROL -> REMOTE;
            case "1110" -> AVOIDING;
            case "1101" -> LINE;
            case "1011" -> DANCE;
            case "0111" -> BOTSTUDIO;
            default -> OTHER;
        };
    }

    /** Whether speeds stay 0. */
    public boolean holdsMotors() {
        return this == BOTSTUDIO || this == OTHER;
    }

    /** Whether the greeting has a fourth line. */
    public boolean isInternal() {
        return this != REMOTE && this != BOTSTUDIO;
    }
}
