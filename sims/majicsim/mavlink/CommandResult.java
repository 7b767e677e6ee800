package majicsim.mavlink;

/** The answers to a command, with the numbers of COMMAND_ACK (sheet 8). */
enum CommandResult {
    ACCEPTED,
    NOT_NOW,
    DENIED,
    UNSUPPORTED,
    FAILED
}
