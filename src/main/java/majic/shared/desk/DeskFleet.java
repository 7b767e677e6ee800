package majic.shared.desk;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.bot.BotException;
import majic.shared.vda5050.FleetVehicle;

/**
 * The shared robots as vehicles of VDA 5050. Vehicles connect on the worker of the desk, because that may block; a
 * robot whose connection fails is shared all the same. Thread-safe.
 */
final class DeskFleet {
    private final DeskContext desk;
    private final String site;
    private final DeskSharing.ConnectionOpener opener;
    private final Map<SharedRobot, FleetVehicle> vehicles = new ConcurrentHashMap<>();

    DeskFleet(DeskContext desk, String site, DeskSharing.ConnectionOpener opener) {
        this.desk = desk;
        this.site = site;
        this.opener = opener;
    }

    void add(SharedRobot robot) {
        desk.connection().time().tryRunAsync("vehicle " + robot.member().number() + " of VDA 5050", () -> start(robot));
    }

    private void start(SharedRobot robot) {
        String run = desk.self().session();
        FleetVehicle vehicle = new FleetVehicle(
                desk.team(), robot, site, desk.self().desk(), (client, will) -> opener.open(client + "-" + run, will));
        vehicles.put(robot, vehicle);
        if (robot.isRemoved()) {
            remove(robot);
            return;
        }
        try {
            vehicle.start();
        } catch (BotException e) {
            vehicles.remove(robot);
            vehicle.close();
            robot.notice("not published as a vehicle of VDA 5050: " + e.getMessage());
        }
    }

    void tick() {
        vehicles.values().forEach(FleetVehicle::tick);
    }

    void remove(SharedRobot robot) {
        FleetVehicle vehicle = vehicles.remove(robot);
        if (vehicle != null) {
            vehicle.close();
        }
    }
}
