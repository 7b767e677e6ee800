package majic.mavlink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.mavlink.panel.MavlinkReplay;

/** Vehicles that speak MAVLink among the types of robots. */
public final class MavlinkType implements BotType {
    private static final String USUAL_PLACE = "mavlink:udp://:14550";

    /** Used by the service loader. */
    public MavlinkType() {}

    @Override
    public String name() {
        return MavlinkAddress.SCHEME;
    }

    @Override
    public boolean isOneOfSeveral() {
        return true;
    }

    @Override
    public String label() {
        return "MAVLink vehicle";
    }

    @Override
    public String make() {
        return "MAVLink vehicle";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP, Reach.SERIAL);
    }

    @Override
    public int defaultPort(String scheme) {
        return MavlinkAddress.TCP_PORT;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return new MajicMavlink(address, environment);
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new MavlinkReplay(recorded);
    }

    @Override
    public Map<String, String> robotsAt(BotAddress address, BotEnvironment environment) {
        String place = address.toString().replaceFirst("/?(\\?.*)?$", "");
        Map<String, String> robots = new LinkedHashMap<>();
        VehicleSearch.search(MavlinkAddress.parse(address).endpoint(), environment.time())
                .forEach((system, vehicle) -> robots.put(place + "?system=" + system, vehicle));
        return robots;
    }

    @Override
    public Map<String, String> robotsSending(BotEnvironment environment) {
        return robotsAt(BotAddress.parse(USUAL_PLACE), environment);
    }

    @Override
    public String advice() {
        return "Is the vehicle on, its radio or network connected, and no other ground station using the connection? A"
                + " vehicle sends by UDP to the address that is set in it, usually to port 14550 of this computer.";
    }
}
