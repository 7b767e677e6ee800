package majic.gui.command;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/**
 * Holds the lines typed before, each once, to be recalled and searched. The unfinished line from which recalling
 * started is kept at its newer end. Must be used on one thread.
 */
final class History {
    static final int LONGEST = 500;

    private final List<String> lines = new ArrayList<>();
    private int place;
    private String unfinished = "";

    /** Adds a line as the newest one, in place of an equal earlier one, and returns to the newest end. */
    void add(String line) {
        if (!line.isBlank()) {
            lines.remove(line);
            lines.add(line);
        }
        forgetOldest();
    }

    /** Adds lines, oldest first, that are older than all that are there, and returns to the newest end. */
    void addOlder(List<String> earlier) {
        List<String> newer = List.copyOf(lines);
        lines.clear();
        earlier.forEach(this::add);
        newer.forEach(this::add);
    }

    private void forgetOldest() {
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

    /** Returns the lines that contain a text in any case, newest first. */
    List<String> containing(String part) {
        String sought = part.strip().toLowerCase(Locale.ROOT);
        List<String> found = new ArrayList<>(lines);
        Collections.reverse(found);
        found.removeIf(line -> !line.toLowerCase(Locale.ROOT).contains(sought));
        return found;
    }

    private String current() {
        return place == lines.size() ? unfinished : lines.get(place);
    }
}
