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

    /**
     * Takes further bytes of a body, up to the first closing bracket inside quotes.
     *
     * @param bodyStart the index at which the body starts
     * @return the index behind the last byte that was taken
     */
    int take(byte[] bytes, int from, int to, int bodyStart) {
        if (from == bodyStart && from < to) {
            structured = bytes[from] == '"' || bytes[from] == '[';
        }
        if (!structured) {
            return to;
        }
        for (int index = from; index < to; index++) {
            byte next = bytes[index];
            if (!quoted) {
                track(next, index);
            } else {
                quoted = escaped || next != '"';
                escaped = !escaped && next == '\\';
                if (next == ']') {
                    return index + 1;
                }
            }
        }
        return to;
    }

    private void track(byte next, int index) {
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
