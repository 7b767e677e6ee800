package majicsim.net;

/** How many clients a port serves at a time. */
public enum Clients {
    /** One; another is turned away at once. */
    ONE,
    /** Any number. */
    MANY
}
