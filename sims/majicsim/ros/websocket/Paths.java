package majicsim.ros.websocket;

/** Which paths of an address a server answers at. */
public enum Paths {
    /** Any path. */
    ANY,
    /** {@code /} alone; others are not found. */
    ROOT
}
