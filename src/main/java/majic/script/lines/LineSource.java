package majic.script.lines;

/** Where lines come from, which decides what waits for what. */
public enum LineSource {
    /** A user at a prompt or window: readings at once, blocks beside the next lines, a full queue refuses. */
    PROMPT,
    /** A pipe or file: every line takes its turn. */
    PIPE,
    /** A program at the other end of a socket: as a pipe, but a stop never waits, since it may be urgent. */
    SOCKET,
    /** A program on another computer: as at a socket, but it may write no file of this one. */
    NETWORK
}
