package majic.mavlink.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.mavlink.motion.FlightFence;
import majic.mavlink.session.FlightModes;
import majic.mavlink.session.VehicleClass;

/** The commands of a vehicle, by its kind. */
public final class VehicleCommands {
    /** All that any vehicle has. */
    public static final List<String> NAMES =
            List.of("arm", "disarm", "takeoff", "climb", "gotoGlobal", "hold", "land", "surface", "home");

    private static final double TO_E7 = 1e7;
    private static final double LEAST_TAKE_OFF_MM = 500;

    private final VehicleAccess access;

    /** Makes no command yet. */
    public VehicleCommands(VehicleAccess access) {
        this.access = access;
    }

    /** Returns the commands of a kind of vehicle. */
    public List<DriverCommand> of(VehicleClass vehicle, FlightModes modes) {
        List<DriverCommand> commands = new ArrayList<>();
        if (vehicle.isMoved() && modes.guided().isPresent()) {
            commands.add(new DriverCommand(
                    "arm",
                    List.of(),
                    true,
                    "lets its motors turn; refused with the reasons of the autopilot",
                    this::arm));
            commands.add(new DriverCommand("disarm", List.of(), false, "stops its motors for good", this::disarm));
        }
        if (vehicle == VehicleClass.COPTER && modes.guided().isPresent()) {
            commands.add(new DriverCommand(
                    "takeoff",
                    List.of(Parameter.number("height", Unit.MM, "above its home position")
                            .within(LEAST_TAKE_OFF_MM, FlightFence.LARGEST_MM)),
                    true,
                    "takes off and waits until the height is reached",
                    (values, motion) ->
                            access.alone().motion().takeOff(values.get(0).number(), motion) + " above home"));
            commands.add(new DriverCommand(
                    "climb",
                    List.of(Parameter.number("distance", Unit.MM, "up positive")
                            .within(-FlightFence.LARGEST_MM, FlightFence.LARGEST_MM)),
                    true,
                    "changes its height",
                    (values, motion) -> access.alone()
                            .motion()
                            .climb(values.get(0).number(), motion)
                            .toString()));
        }
        if (vehicle.isOnSurface() && modes.guided().isPresent()) {
            commands.add(new DriverCommand(
                    "gotoGlobal",
                    List.of(
                            Parameter.number("latitude", Unit.LAT_LON, "north positive")
                                    .within(-90, 90),
                            Parameter.number("longitude", Unit.LAT_LON, "east positive")
                                    .within(-180, 180)),
                    true,
                    "goes to a place on the earth by its own navigation",
                    this::goToGlobal));
        }
        modes.stop()
                .ifPresent(mode ->
                        commands.add(mode("hold", modes.name(mode), "stays where it is, in the mode of a stop")));
        if (!vehicle.isOnSurface()) {
            modes.down()
                    .ifPresent(mode -> commands.add(mode(
                            vehicle == VehicleClass.SUBMARINE ? "surface" : "land",
                            mode,
                            vehicle == VehicleClass.SUBMARINE ? "comes up" : "comes down where it is")));
            modes.home().ifPresent(mode -> commands.add(mode("home", mode, "returns to its home position by itself")));
        }
        return commands;
    }

    private DriverCommand mode(String name, String mode, String help) {
        return new DriverCommand(
                name,
                List.of(),
                true,
                help + " (" + mode + ")",
                (values, motion) -> (name.equals("home") ? access.alone() : access.open())
                        .motion()
                        .setMode(mode, motion)
                        .answer("in " + mode));
    }

    private String arm(List<Value> values, Motion motion) {
        return access.alone().motion().arm(motion).answer("armed");
    }

    private String disarm(List<Value> values, Motion motion) {
        return access.alone().motion().disarm(motion).answer("disarmed");
    }

    private String goToGlobal(List<Value> values, Motion motion) {
        return access.alone()
                .motion()
                .goToGlobal(
                        (int) Math.round(TO_E7 * values.get(0).number()),
                        (int) Math.round(TO_E7 * values.get(1).number()),
                        motion);
    }
}
