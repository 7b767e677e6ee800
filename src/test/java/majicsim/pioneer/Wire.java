package majicsim.pioneer;

import java.io.IOException;

/** The client's end of a real connection to the robot. */
interface Wire {
    /** As the robot's port counts it. */
    String key();

    void write(byte[] bytes) throws IOException;

    /** Waits for so many bytes; fewer if the robot hangs up before. */
    byte[] read(int count) throws IOException;

    /** Changes the speed of a serial line. */
    default void baud(int bitsPerSecond) {}

    /** The client is gone without CLOSE. */
    void vanish() throws IOException;

    /** Whether the robot's end notices that the client is gone; that of a serial line does not. */
    boolean isNoticed();
}
