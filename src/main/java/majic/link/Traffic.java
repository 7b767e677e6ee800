package majic.link;

/**
 * Counts of the bytes that a link has carried. A stepped simulated lab compares them with the counts of its robots, to
 * detect bytes that have not arrived yet.
 *
 * @param local the address of this end: {@code 127.0.0.1:40312}, or the name of the serial port
 * @param remote the other end
 * @param written bytes passed to the system so far, counted before they are passed
 * @param consumed bytes read and handled, counted when the reader reads again
 * @param open false once the link is closed, or its reader thread has ended after the end of the link
 */
public record Traffic(String local, String remote, long written, long consumed, boolean open) {}
