package majic.gui.command;

import java.util.ArrayList;
import java.util.List;

/**
 * The lines typed before, to walk through. What was being typed when the walk began waits at its newer end. Used on one
 * thread.
 */
final class History {
    private static final int LONGEST = 500;

    private final List<String> lines = new ArrayList<>();
    private int place;
    private String unfinished = "";

    /** Takes in an accepted line and ends the walk; a repetition of the last one is kept once. */
    void add(String line) {
        if (!line.isBlank() && (lines.isEmpty() || !lines.get(lines.size() - 1).equals(line))) {
            lines.add(line);
        }
        if (lines.size() > LONGEST) {
            lines.remove(0);
        }
        place = lines.size();
    }

    /** The line before; at the oldest one, that. */
    String older(String shown) {
        if (place == lines.size()) {
            unfinished = shown;
        }
        if (place > 0) {
            place--;
        }
        return current();
    }

    /** The line after; past the newest one, what was being typed. */
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
