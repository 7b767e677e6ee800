package majic.pioneer.session;

/** Makes the connections of one robot, over a link or through a library. */
public interface ConnectionMaker {
    /**
     * Makes the connection of the next session; opens nothing.
     *
     * @param address as a link gives it: {@code tcp:host:port}, {@code serial:/dev/ttyS0}
     * @param wait of the thread that connects
     */
    PioneerConnection make(String address, ConnectWait wait);
}
