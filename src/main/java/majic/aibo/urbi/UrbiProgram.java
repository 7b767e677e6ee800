package majic.aibo.urbi;

/**
 * The program text of commands, without comments and quoted texts, as the server's splitter sees it (URBI sheet 3). No
 * comment begins inside quotes and no quote inside a comment, so both are found in one pass.
 */
final class UrbiProgram {
    private final String commands;
    private final StringBuilder bare = new StringBuilder();
    private boolean commented;
    private boolean open;

    private UrbiProgram(String commands) {
        this.commands = commands;
    }

    static UrbiProgram of(String commands) {
        UrbiProgram program = new UrbiProgram(commands);
        int at = 0;
        while (at < commands.length()) {
            at = program.take(at);
        }
        return program;
    }

    /** The program, each text in it as {@code ""} and each comment as a blank. */
    String bare() {
        return bare.toString();
    }

    boolean hasComments() {
        return commented;
    }

    /** Whether a quote or a comment is not closed, so that the server would wait for the rest. */
    boolean isOpen() {
        return open;
    }

    /** Takes the element that begins at an index; returns the index of the next one. */
    private int take(int at) {
        if (commands.charAt(at) == '"') {
            bare.append("\"\"");
            return endOfText(at + 1);
        }
        if (commands.startsWith("/*", at)) {
            return endOfComment(at + 2, "*/");
        }
        if (commands.startsWith("//", at) || commands.charAt(at) == '#') {
            return endOfComment(at + 1, "\n");
        }
        bare.append(commands.charAt(at));
        return at + 1;
    }

    private int endOfText(int start) {
        int at = start;
        while (at < commands.length() && commands.charAt(at) != '"') {
            at += commands.charAt(at) == '\\' ? 2 : 1;
        }
        open |= at >= commands.length();
        return at + 1;
    }

    private int endOfComment(int start, String mark) {
        bare.append(' ');
        commented = true;
        int end = commands.indexOf(mark, start);
        open |= end < 0;
        return end < 0 ? commands.length() : end + mark.length();
    }
}
