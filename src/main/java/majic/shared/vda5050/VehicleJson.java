package majic.shared.vda5050;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.team.Member;
import majic.time.WaitPolicy;

/**
 * The content of the messages of a vehicle: metres, radians, kilograms. Asks the robot nothing and waits for nothing.
 */
final class VehicleJson {
    /** The specification has no value for an unknown charge; this is its value for "good". */
    private static final int UNKNOWN_CHARGE = 80;

    private static final double MM_PER_M = 1000;

    private VehicleJson() {}

    /** Writes position, speed, battery and safety. */
    static void state(ObjectNode json, Member member, String map, boolean latched) {
        MajicBot bot = member.bot();
        BotState state = bot.state();
        json.put("orderId", "").put("orderUpdateId", 0).put("lastNodeId", "").put("lastNodeSequenceId", 0);
        json.put("driving", state.moving()).put("paused", latched).put("operatingMode", "MANUAL");
        json.putArray("nodeStates");
        json.putArray("edgeStates");
        WaitPolicy.observing(() -> {
            if (bot.reading("pose").isCurrent()) {
                movement(json, bot, map);
            }
            battery(json, bot);
            json.putObject("safetyState")
                    .put("eStop", latched ? "REMOTE" : "NONE")
                    .put("fieldViolation", isBumped(bot));
        });
    }

    /** Both are optional, and left out while there is no present reading. */
    private static void movement(ObjectNode json, MajicBot bot, String map) {
        BotState state = bot.state();
        json.putObject("agvPosition")
                .put("x", metres(state.pose().xMm()))
                .put("y", metres(state.pose().yMm()))
                .put("theta", radians(state.pose().headingDeg()))
                .put("mapId", map)
                .put("positionInitialized", bot.placedAt().isPresent());
        json.putObject("velocity")
                .put("vx", metres(state.speedMmPerSec()))
                .put("vy", 0)
                .put("omega", Math.toRadians(state.turnRateDegPerSec()));
    }

    private static double metres(double mm) {
        return Math.rint(mm) / MM_PER_M;
    }

    /** In the range from -pi to pi. */
    private static double radians(double degrees) {
        return Math.toRadians(Math.IEEEremainder(degrees, 360));
    }

    private static void battery(ObjectNode json, MajicBot bot) {
        OptionalDouble charge = reading(bot, Unit.PERCENT, "charge", "battery");
        ObjectNode battery = json.putObject("batteryState");
        battery.put("batteryCharge", charge.orElse(UNKNOWN_CHARGE)).put("charging", isYes(bot, "charging"));
        reading(bot, Unit.V, "voltage", "battery").ifPresent(volts -> battery.put("batteryVoltage", volts));
        ArrayNode information = json.putArray("information");
        if (charge.isEmpty()) {
            information
                    .addObject()
                    .put("infoType", "batteryChargeUnknown")
                    .put("infoLevel", "INFO")
                    .put("infoDescription", "the robot reports no charge; batteryCharge has no meaning");
        }
    }

    private static OptionalDouble reading(MajicBot bot, Unit unit, String... words) {
        for (Parameter parameter : bot.parameters()) {
            String name = parameter.name().toLowerCase(Locale.ROOT);
            boolean meant = List.of(words).stream().anyMatch(name::contains);
            if (meant
                    && parameter.readable()
                    && parameter.unit() == unit
                    && parameter.kind() == Parameter.Kind.NUMBER) {
                return read(bot, parameter) instanceof Value.Number number
                        ? OptionalDouble.of(number.amount())
                        : OptionalDouble.empty();
            }
        }
        return OptionalDouble.empty();
    }

    private static boolean isBumped(MajicBot bot) {
        return isYes(bot, "bumped");
    }

    private static boolean isYes(MajicBot bot, String name) {
        return bot.parameters().stream()
                .filter(parameter -> parameter.readable() && parameter.name().equalsIgnoreCase(name))
                .anyMatch(parameter -> read(bot, parameter).isYes());
    }

    private static Value read(MajicBot bot, Parameter parameter) {
        try {
            return bot.get(parameter.name());
        } catch (BotException e) {
            return Value.unknown(String.valueOf(e.getMessage()));
        }
    }

    /** Writes what the vehicle is and can do. */
    static void factsheet(ObjectNode json, MajicBot bot) {
        BotProfile profile = bot.profile();
        ObjectNode type = json.putObject("typeSpecification")
                .put("seriesName", bot.type().label())
                .put("seriesDescription", bot.introduction())
                .put("agvKinematic", "DIFF")
                .put("agvClass", "CARRIER")
                .put("maxLoadMass", 0);
        type.putArray("localizationTypes").add("NATURAL");
        type.putArray("navigationTypes").add("AUTONOMOUS");
        double size = metres(2 * profile.bodyMm());
        json.putObject("physicalParameters")
                .put("speedMin", 0)
                .put("speedMax", metres(profile.speed().max()))
                .put("accelerationMax", 0)
                .put("decelerationMax", 0)
                .put("heightMin", 0)
                .put("heightMax", 0)
                .put("width", size)
                .put("length", size);
        protocol(json);
        json.putObject("agvGeometry").putArray("wheelDefinitions");
        json.putObject("loadSpecification").putArray("loadPositions");
    }

    private static void protocol(ObjectNode json) {
        ObjectNode limits = json.putObject("protocolLimits");
        limits.putObject("maxStringLens");
        limits.putObject("maxArrayLens").put("instantActions", 20);
        limits.putObject("timing").put("minOrderInterval", 0).put("minStateInterval", FleetVehicle.SHORTEST_S);
        ObjectNode features = json.putObject("protocolFeatures");
        features.putArray("optionalParameters");
        ArrayNode actions = features.putArray("agvActions");
        action(actions, "startPause", "stops the robot for good; nothing resumes by itself");
        action(actions, "cancelOrder", "stops the robot");
        action(actions, "stateRequest", "sends the state at once");
        action(actions, "factsheetRequest", "sends the factsheet at once");
    }

    private static void action(ArrayNode to, String type, String description) {
        ObjectNode action = to.addObject().put("actionType", type).put("actionDescription", description);
        action.putArray("actionScopes").add("INSTANT");
        action.putArray("blockingTypes").add("NONE").add("SOFT").add("HARD");
    }
}
