package majicsim.hemisson.behaviour;

/** The behaviour of a running mode. It sets speeds and LEDs repeatedly and so overrides a client's commands. */
public interface Behaviour {
    /** The mode begins. */
    default void begin() {}

    /** Lets time pass. */
    default void step(double seconds) {}

    /** Whether it does nothing before the sensors are read anew. */
    default boolean isIdle() {
        return true;
    }

    /** The sensors were read anew. */
    default void sensorsRead() {}
}
