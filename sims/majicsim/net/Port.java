package majicsim.net;

import java.util.List;

/** A place where clients reach one firmware. */
public interface Port extends AutoCloseable {
    /**
     * How a client reaches it.
     *
     * @return "host:port" or the path of a device
     */
    String address();

    /**
     * What distinguishes it from the robot's other ports.
     *
     * @return what follows the robot's name in the name of this address; empty for a TCP port
     */
    default String suffix() {
        return "";
    }

    /**
     * Reports that lab time has advanced: sends and delivers what was held back and is due. Called with the lab's lock
     * held.
     *
     * @param labNanos lab time
     */
    void step(long labNanos);

    /**
     * The progress of its lines. Cheap, takes no lock, may be called from any thread.
     *
     * @return one entry a line
     */
    List<LineCount> lines();

    /** Closes the port and all its lines, and waits for its thread a moment. */
    @Override
    void close();
}
