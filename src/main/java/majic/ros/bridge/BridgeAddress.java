package majic.ros.bridge;

import majic.link.Link;
import majic.link.Links;

/**
 * Where a rosbridge server is. Immutable.
 *
 * @param host its name or address; IPv6 in brackets
 * @param port its TCP port
 * @param path of the service, with a slash at its beginning; the servers' default is {@code /}
 * @param secure whether the connection uses TLS
 */
public record BridgeAddress(String host, int port, String path, boolean secure) {
    /** The port of a server that is not configured otherwise. */
    public static final int PORT = 9090;

    /**
     * Returns both as an address names them.
     *
     * @return {@code host:port}
     */
    public String hostAndPort() {
        return host + ":" + port;
    }

    Link newLink() {
        return secure ? Links.secure(host, port) : Links.of("//" + hostAndPort(), PORT, 0);
    }

    @Override
    public String toString() {
        return (secure ? "wss://" : "ws://") + hostAndPort() + path;
    }
}
