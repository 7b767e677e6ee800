package majicsim.hemisson.behaviour;

import majicsim.hemisson.options.HemissonOptions;

/** What the firmware does beside answering; taken from the switches at start-up (sheet 7). */
public enum RunMode {
    /** The serial line and the TV remote drive. */
    REMOTE,
    /** It drives about and keeps off obstacles. */
    AVOIDING,
    /** It follows black tape. */
    LINE,
    /** It swings to and fro. */
    DANCE,
    /** A BotStudio program from an EEPROM that is empty: speeds stay 0, whatever is commanded. */
    BOTSTUDIO,
    /** Any other setting: speeds stay 0, and it looks at its receiver so rarely that a longer command blocks its receiver. */
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
