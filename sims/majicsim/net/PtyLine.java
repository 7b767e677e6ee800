package majicsim.net;

/**
 * The one line of a pseudo-terminal. Bytes that are not read fill the system's buffer; further ones are lost, as on a
 * real serial wire.
 */
final class PtyLine extends RobotLine {
    private final PseudoTerminal terminal;

    PtyLine(PseudoTerminal terminal, Wiring wiring) {
        super(terminal.path(), terminal.path(), wiring, false);
        this.terminal = terminal;
    }

    @Override
    int write(byte[] bytes) {
        return terminal.write(bytes);
    }

    @Override
    boolean isFlushed() {
        return true;
    }

    @Override
    public int baud() {
        return terminal.baud();
    }

    /** A serial line cannot be closed from the robot's side. */
    @Override
    public void close() {}
}
