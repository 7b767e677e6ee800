package majic.hemisson.line;

import java.util.Locale;

/**
 * How long the driver waits on a kind of connection, seconds. Immutable.
 *
 * @param answerSeconds how long an answer may take (Hemisson sheet 4.6)
 * @param stallSeconds how long after the last command one that was not answered may still be held somewhere on its way,
 *     to arrive together with the next
 */
record LineTimes(double answerSeconds, double stallSeconds) {
    /** A serial port: a character that was not answered is almost certainly lost. */
    static final LineTimes CABLE = new LineTimes(0.3, 0.3);

    /** A serial server or a radio: it loses nothing, but may hold bytes for a while and deliver them together. */
    static final LineTimes BUFFERED = new LineTimes(1, 2);

    /** The times for a link by its address, as {@code serial:COM3} or {@code tcp:10.0.0.5:4001}. */
    static LineTimes of(String address) {
        boolean bluetooth =
                address.contains("rfcomm") || address.toLowerCase(Locale.ROOT).contains("bluetooth");
        return bluetooth || address.startsWith("tcp:") ? BUFFERED : CABLE;
    }
}
