package majicsim.pioneer;

import java.io.IOException;

/** One session of another project's client, in pieces. */
interface VendorClient {
    void connect() throws IOException;

    void driveAndRead() throws IOException;

    void disconnect() throws IOException;

    /** Ends without CLOSE, as a program that is killed. */
    void vanish() throws IOException;
}
