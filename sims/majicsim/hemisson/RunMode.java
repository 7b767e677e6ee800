package majicsim.hemisson;

/** What the firmware does beside answering; taken from the switches at start-up (sheet 7). */
enum RunMode {
    /** The serial line and the TV remote drive. */
    REMOTE,
    /** Any other setting, with an empty EEPROM: speeds stay 0, whatever is commanded. */
    HELD;

    static RunMode of(String switches) {
        return switches.equals(HemissonOptions.REMOTE_CONTROL) ? REMOTE : HELD;
    }
}
