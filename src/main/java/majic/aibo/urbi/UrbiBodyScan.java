package majic.aibo.urbi;

/**
 * Keeps track of quotes and brackets while the body of a message comes in. Only bodies that start with a quote or a
 * bracket are values with structure; information and errors may hold any single quote or bracket (URBI sheet 4).
 */
final class UrbiBodyScan {
    private boolean structured;
    private boolean quoted;
    private boolean escaped;
    private int depth;
    private int elementStart = -1;

    /** Takes the byte at an index of a body that starts at another. */
    void take(byte next, int index, int bodyStart) {
        if (index == bodyStart) {
            structured = next == '"' || next == '[';
        }
        if (structured) {
            track(next, index);
        }
    }

    private void track(byte next, int index) {
        if (quoted) {
            quoted = escaped || next != '"';
            escaped = !escaped && next == '\\';
            return;
        }
        switch (next) {
            case '"' -> quoted = true;
            case '[' -> {
                depth++;
                elementStarts(index + 1);
            }
            case ']' -> depth--;
            case ',' -> elementStarts(index + 1);
            default -> {}
        }
    }

    boolean isQuoted() {
        return quoted;
    }

    boolean isInList() {
        return depth > 0;
    }

    void elementStarts(int index) {
        elementStart = index;
    }

    /** Where the newest element of the list starts; the whole body if it is no list. */
    int elementStart(int bodyStart) {
        return depth > 0 ? elementStart : bodyStart;
    }

    void reset() {
        structured = false;
        quoted = false;
        escaped = false;
        depth = 0;
        elementStart = -1;
    }
}
