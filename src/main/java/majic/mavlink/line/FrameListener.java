package majic.mavlink.line;

import java.io.IOException;
import majic.mavlink.frame.MavlinkFrame;

/** Receives what arrives on a connection, on its reader thread, and must not wait. */
public interface FrameListener {
    /** The number of the vehicle that is used; 0 while it is not known, on any thread. */
    int system();

    /** Takes a frame, of whatever vehicle. */
    void received(MavlinkFrame frame);

    /**
     * Takes note that a second autopilot sends with the number of a vehicle, whose frames are left out.
     *
     * @param system the number
     * @param address where they come from
     */
    void ignored(int system, String address);

    /**
     * Takes the end of the connection; called once, unless the listener has left it before.
     *
     * @param cause half a sentence
     */
    void ended(IOException cause);
}
