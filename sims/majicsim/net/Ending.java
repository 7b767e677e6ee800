package majicsim.net;

/** Whether a line has ended, and by which end. */
enum Ending {
    /** Not at all: the line is open. */
    NONE,
    /** The firmware closed it; what it sent before still goes out. */
    BY_ROBOT,
    /** The client closed its end; what it sent before is still delivered. */
    BY_CLIENT,
    /** A fault or the port's own end; what is under way is lost. */
    CUT
}
