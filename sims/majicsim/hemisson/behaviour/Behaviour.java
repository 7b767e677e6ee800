package majicsim.hemisson.behaviour;

/** What a running mode does by itself. It sets speeds and LEDs again and again, past whatever a client commands. */
public interface Behaviour {
    /** The mode begins. */
    default void begin() {}

    /** Lets time pass. */
    default void step(double seconds) {}

    /** The sensors were read anew. */
    default void look() {}
}
