package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import majic.bot.Beam;
import majic.bot.BotCommand;
import majic.bot.BotProfile;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeSensor;
import majic.bot.Unit;

/** The JSON of the parts of a description. */
final class DescriptionJson {
    private static final String BEAMS = "beams";
    private static final int BEAM_NUMBERS = 7;

    private DescriptionJson() {}

    static ObjectNode of(BotProfile profile) {
        ObjectNode json = JsonObject.create().put("bodyMm", profile.bodyMm());
        json.set("speed", of(profile.speed()));
        json.set("turn", of(profile.turn()));
        if (profile.leavesGround()) {
            json.put("leavesGround", true);
        }
        return json.put("slowestMmPerSec", profile.slowestMmPerSec())
                .put("slowestTurnDegPerSec", profile.slowestTurnDegPerSec())
                .put("cruiseMmPerSec", profile.cruiseMmPerSec())
                .put("cruiseTurnDegPerSec", profile.cruiseTurnDegPerSec())
                .put("nearMm", profile.nearMm())
                .put("estimates", profile.estimates());
    }

    static BotProfile profile(JsonObject json) {
        return new BotProfile(
                json.number("bodyMm"),
                range(json.object("speed")),
                range(json.object("turn")),
                json.number("slowestMmPerSec", 1),
                json.number("slowestTurnDegPerSec", 1),
                json.number("cruiseMmPerSec"),
                json.number("cruiseTurnDegPerSec"),
                json.number("nearMm"),
                json.flag("estimates", false),
                json.flag("leavesGround", false));
    }

    /** An end without a limit is left out. */
    private static ObjectNode of(Range range) {
        ObjectNode json = JsonObject.create();
        if (range.min() > Range.ANY.min()) {
            json.put("min", range.min());
        }
        return range.max() < Range.ANY.max() ? json.put("max", range.max()) : json;
    }

    private static Range range(JsonObject json) {
        double min = json.number("min", Range.ANY.min());
        double max = json.number("max", Range.ANY.max());
        if (min > max) {
            throw json.wrong("min", "it is not more than max");
        }
        return new Range(min, max);
    }

    static ArrayNode of(List<Parameter> parameters) {
        ArrayNode all = JsonObject.create().arrayNode();
        parameters.forEach(parameter -> all.add(of(parameter)));
        return all;
    }

    private static ObjectNode of(Parameter parameter) {
        ObjectNode json = JsonObject.create().put("name", parameter.name());
        json.put("kind", parameter.kind().name().toLowerCase(Locale.ROOT))
                .put("unit", parameter.unit().symbol());
        if (!parameter.range().equals(Range.ANY)) {
            json.set("range", of(parameter.range()));
        }
        if (parameter.whole()) {
            json.put("whole", true);
        }
        if (!parameter.choices().isEmpty()) {
            ArrayNode choices = json.putArray("choices");
            parameter.choices().forEach(choices::add);
        }
        json.put("readable", parameter.readable()).put("writable", parameter.writable());
        json.put("moves", parameter.moves());
        if (!parameter.extras().isEmpty()) {
            json.set("extras", of(parameter.extras()));
        }
        return json.put("help", parameter.help());
    }

    static List<Parameter> parameters(JsonObject json, String field) {
        return json.objects(field).stream().map(DescriptionJson::parameter).toList();
    }

    private static Parameter parameter(JsonObject json) {
        return new Parameter(
                json.text("name"),
                kind(json.text("kind", "")),
                unit(json.text("unit", "")),
                json.has("range") ? range(json.object("range")) : Range.ANY,
                json.flag("whole", false),
                json.texts("choices"),
                json.flag("readable", true),
                json.flag("writable", false),
                json.flag("moves", false),
                parameters(json, "extras"),
                json.text("help", ""));
    }

    /** A kind that this version does not know is shown as a text. */
    private static Parameter.Kind kind(String word) {
        for (Parameter.Kind kind : Parameter.Kind.values()) {
            if (kind.name().equalsIgnoreCase(word)) {
                return kind;
            }
        }
        return Parameter.Kind.TEXT;
    }

    /** A unit that this version does not know is left out. */
    static Unit unit(String symbol) {
        for (Unit unit : Unit.values()) {
            if (unit.symbol().equals(symbol)) {
                return unit;
            }
        }
        return Unit.NONE;
    }

    static ObjectNode of(BotCommand command) {
        ObjectNode json = JsonObject.create().put("name", command.name());
        json.set("arguments", of(command.arguments()));
        if (!command.repeated().isEmpty()) {
            json.set("repeated", of(command.repeated()));
        }
        return json.put("moves", command.moves()).put("help", command.help()).put("raw", command.raw());
    }

    static BotCommand command(JsonObject json) {
        return new BotCommand(
                json.text("name"),
                parameters(json, "arguments"),
                parameters(json, "repeated"),
                json.flag("moves", true),
                json.text("help", ""),
                json.flag("raw", false));
    }

    /** A beam is written as far as it differs from the one before, so that a laser scanner is a list of angles. */
    static ObjectNode of(RangeSensor sensor) {
        ObjectNode json = JsonObject.create().put("name", sensor.name());
        ArrayNode beams = json.putArray(BEAMS);
        double[] before = new double[0];
        for (Beam beam : sensor.beams()) {
            double[] numbers = numbers(beam);
            int last = numbers.length;
            while (last > 0 && before.length > 0 && numbers[last - 1] == before[last - 1]) {
                last--;
            }
            ArrayNode written = beams.addArray();
            Arrays.stream(numbers, 0, last).forEach(written::add);
            before = numbers;
        }
        return json;
    }

    private static double[] numbers(Beam beam) {
        Pose mount = beam.mount();
        return new double[] {
            Math.rint(mount.headingDeg() * 1e4) / 1e4,
            mount.xMm(),
            mount.yMm(),
            beam.openingDeg(),
            beam.leastMm(),
            beam.reachMm(),
            beam.noiseMm()
        };
    }

    static RangeSensor sensor(JsonObject json) {
        double[] numbers = new double[BEAM_NUMBERS];
        Arrays.fill(numbers, Double.NaN);
        try {
            return new RangeSensor(json.text("name"), json.list(BEAMS, item -> beam(item, numbers)));
        } catch (IllegalArgumentException e) {
            throw json.wrong(BEAMS, "each beam is its heading, x, y, opening, least and greatest distance and noise");
        }
    }

    /** Reads a beam into the numbers of the one before. */
    private static Beam beam(JsonNode item, double... numbers) {
        if (!item.isArray() || item.size() > numbers.length) {
            throw new IllegalArgumentException("no beam");
        }
        for (int at = 0; at < item.size(); at++) {
            JsonNode number = item.get(at);
            numbers[at] = number.isNumber() ? number.doubleValue() : Double.NaN;
        }
        return new Beam(new Pose(numbers[1], numbers[2], numbers[0]), numbers[3], numbers[4], numbers[5], numbers[6]);
    }
}
