package majic.aibo.liburbi;

import majic.aibo.urbi.UrbiTransport;
import majic.link.TcpConnector;

/** Makes transports that use liburbi-java. */
public final class LiburbiTransports implements UrbiTransport.Maker {
    /** Made when the library is loaded. */
    public LiburbiTransports() {}

    @Override
    public UrbiTransport make(String host, int port) {
        return new LiburbiTransport(new TcpConnector(host, port), LiburbiClient::on);
    }
}
