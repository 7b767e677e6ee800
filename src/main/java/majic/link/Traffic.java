package majic.link;

/**
 * What has gone through a link. A stepped simulated lab compares it with what its robots count, to know that nothing is
 * under way.
 *
 * @param local this end, as the peer sees it: {@code 127.0.0.1:40312}, or the name of the serial port
 * @param remote the other end
 * @param written bytes handed to the system so far, counted before they are
 * @param consumed bytes read and dealt with, counted when the reader comes back for more
 * @param open false once the link is closed, or its reader's thread is over after it saw the end
 */
public record Traffic(String local, String remote, long written, long consumed, boolean open) {}
