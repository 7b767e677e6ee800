package majic.gui.command;

import java.util.ArrayList;
import java.util.List;

/**
 * Holds the lines typed before, to be recalled. The unfinished line from which recalling started is kept at its newer
 * end. Must be used on one thread.
 */
final class History {
    private static final int LONGEST = 500;

    private final List<String> lines = new ArrayList<>();
    private int place;
    private String unfinished = "";

    /** Adds an accepted line and returns to the newest end; a repetition of the last line is not added again. */
    void add(String line) {
        if (!line.isBlank() && (lines.isEmpty() || !lines.get(lines.size() - 1).equals(line))) {
            lines.add(line);
        }
        if (lines.size() > LONGEST) {
            lines.remove(0);
        }
        place = lines.size();
    }

    /** Returns the previous line; at the oldest line, that line. */
    String older(String shown) {
        if (place == lines.size()) {
            unfinished = shown;
        }
        if (place > 0) {
            place--;
        }
        return current();
    }

    /** Returns the next line; after the newest one, the unfinished line. */
    String newer(String shown) {
        if (place == lines.size()) {
            return shown;
        }
        place++;
        return current();
    }

    private String current() {
        return place == lines.size() ? unfinished : lines.get(place);
    }
}
