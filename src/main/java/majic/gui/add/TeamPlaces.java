package majic.gui.add;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.Stream;
import majic.bot.BotAddress;
import majic.link.Links;
import majic.script.Session;
import majic.team.Member;

/** Finds out at which hosts and ports the robots of the team are connected. Blocks, because names are looked up. */
final class TeamPlaces {
    private TeamPlaces() {}

    static Set<InetSocketAddress> of(Session session) {
        Set<InetSocketAddress> places = new HashSet<>();
        for (Member member : session.team().members()) {
            session.address(member)
                    .map(BotAddress::parse)
                    .filter(address -> address.rest().contains("//"))
                    .ifPresent(address -> places(address, member.bot().type().defaultPort(address.type()))
                            .forEach(places::add));
        }
        return places;
    }

    private static Stream<InetSocketAddress> places(BotAddress address, int defaultPort) {
        try {
            InetSocketAddress server = Links.server(address.rest(), defaultPort);
            return Stream.of(InetAddress.getAllByName(server.getHostString()))
                    .map(host -> new InetSocketAddress(host, server.getPort()));
        } catch (UnknownHostException | IllegalArgumentException e) {
            return Stream.of();
        }
    }
}
