package majic.aibo;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.function.Supplier;
import majic.aibo.urbi.LinkTransport;
import majic.aibo.urbi.UrbiTransport;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.link.Links;
import majic.vendor.VendorLibrary;

/** Chooses by a dog's address what carries its messages: the driver's own client, or a library. */
final class AiboTransports {
    static final List<String> LIBRARIES = List.of(VendorLibrary.LIBURBI.word());

    private static final String ADAPTER = "majic.aibo.liburbi.LiburbiTransports";

    private AiboTransports() {}

    /**
     * Returns what makes the transports of a dog's connections.
     *
     * @throws BotException if it is no dog's address, or the library that it names is missing
     */
    static Supplier<UrbiTransport> of(BotAddress address, BotEnvironment environment) {
        InetSocketAddress dog = dog(address);
        if (address.libraryAmong(LIBRARIES).isPresent()) {
            UrbiTransport.Maker maker =
                    VendorLibrary.LIBURBI.create(UrbiTransport.Maker.class, ADAPTER, environment.settings());
            return () -> maker.make(dog.getHostString(), dog.getPort());
        }
        return () -> new LinkTransport(Links.of(address.rest(), AiboType.PORT, 0), environment.time());
    }

    private static InetSocketAddress dog(BotAddress address) {
        String rest = address.rest();
        if (!address.type().equals("aibo") || !rest.startsWith("//") && !rest.startsWith("tcp://")) {
            throw new BotException(address + ": not an Aibo's address; it looks like aibo://192.168.1.20");
        }
        try {
            return Links.server(rest, AiboType.PORT);
        } catch (IllegalArgumentException e) {
            throw new BotException(address.scheme() + ":" + e.getMessage(), e);
        }
    }
}
