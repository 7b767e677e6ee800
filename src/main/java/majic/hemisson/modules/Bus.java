package majic.hemisson.modules;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import majic.hemisson.line.Question;

/** The stock commands for the registers of what is plugged into the I2C bus (Hemisson sheet 4.3). */
final class Bus {
    /** A command must not be longer than 50 characters (sheet 4.2), so it holds no more bytes. */
    static final int MOST_BYTES = 13;

    static final int MOST_REGISTERS = 255;

    private Bus() {}

    /**
     * Reads registers; those of an absent module read 255.
     *
     * @param address the write address, even
     * @param register the first
     * @param count how many, 1 to 255
     */
    static Question read(int address, int register, int count) {
        return Question.ask(
                String.format(Locale.ROOT, "R,%02X,%02X,%02X", address, register, count),
                "r(,\\d{3}){" + count + "}",
                Question.msFor(1 + 4 * count));
    }

    /** Writes one register. The answer of an absent module is the same. */
    static Question write(int address, int register, int value) {
        return Question.ask(
                String.format(Locale.ROOT, "W,%02X,%02X,%02X", address, register, value), "w", Question.msFor(1));
    }

    /** Writes several bytes at once; the robot sends their count first. */
    static Question write(int address, int register, List<Integer> bytes) {
        String hex = bytes.stream()
                .map(value -> String.format(Locale.ROOT, ",%02X", value))
                .collect(Collectors.joining());
        return Question.ask(
                String.format(Locale.ROOT, "Y,%02X,%02X,%02X", address, register, bytes.size()) + hex,
                "y",
                Question.msFor(1 + 3 * bytes.size()));
    }
}
