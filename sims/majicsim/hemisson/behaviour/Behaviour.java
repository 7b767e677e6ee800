package majicsim.hemisson.behaviour;

/** The behaviour of a running mode. It sets speeds and LEDs repeatedly and so overrides a client's commands. */
public interface Behaviour {
    /** The mode begins. */
    default void begin() {}

    /** Lets time pass. */
    default void step(double seconds) {}

    /** The sensors were read anew. */
    default void look() {}
}
