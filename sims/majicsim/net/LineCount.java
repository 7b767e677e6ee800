package majicsim.net;

/**
 * The progress of a line's robot end, for a clock that waits until no data is in transit. A line that has ended is no
 * longer counted.
 *
 * @param robot the robot's end: {@code 127.0.0.1:port}, or the path of the pseudo-terminal
 * @param peer as {@link Line#peer()}
 * @param consumed bytes read from the client and processed; counted after the firmware has finished with them, and so
 *     after the replies to them were counted; bytes that jitter or delay hold back count when they are held back
 * @param written bytes given to the client; counted just before they are written
 * @param open whether the robot's end still takes messages, or keeps some that only lab time will release
 * @param unread whether the robot's end leaves bytes unread on purpose (ordered fault), so that waiting for them is
 *     useless
 */
public record LineCount(String robot, String peer, long consumed, long written, boolean open, boolean unread) {}
