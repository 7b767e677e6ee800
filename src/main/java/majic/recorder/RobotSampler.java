package majic.recorder;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.recorder.RecordingFormat.Kind;
import majic.team.Member;
import majic.team.Owner;
import majic.team.StopStatus;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Finds what has changed of one robot since the last time: its parameters, the reports that its panel needs, what the
 * team knows of it. Sends the robot nothing and waits for nothing. Samples are taken by one thread.
 */
final class RobotSampler {
    /** Changes all the time and follows from the times of the other values. */
    private static final String AGE = "age";

    /** How often a robot that reports nothing is sampled: its owner and its settings may change. */
    private static final double QUIET_PERIOD_S = 0.5;

    private final Member member;
    private final RecordedRobot robot;
    private final Map<String, Value> values = new HashMap<>();
    private final Map<Kind, Map<String, String>> texts = new EnumMap<>(Kind.class);
    private final Map<String, String> reports = new HashMap<>();
    private volatile boolean forgotten = true;
    private volatile boolean reported = true;
    private double sampledS = Double.NEGATIVE_INFINITY;

    RobotSampler(Member member, RecordedRobot robot) {
        this.member = member;
        this.robot = robot;
    }

    /** Describes everything anew the next time. Called by any thread. */
    void forget() {
        forgotten = true;
    }

    /** The robot has reported something. Called by any thread. */
    void reported() {
        reported = true;
    }

    /** Adds a line for each change, if the robot has reported something or was not sampled for a while. */
    void sample(StringBuilder lines, StopStatus stops, double nowS) {
        if (reported || forgotten || nowS - sampledS >= QUIET_PERIOD_S) {
            reported = false;
            sampledS = nowS;
            sample(lines, stops);
        }
    }

    private void sample(StringBuilder lines, StopStatus stops) {
        if (forgotten) {
            forgotten = false;
            values.clear();
            texts.clear();
            reports.clear();
            lines.append(RecordingFormat.robot(robot));
        }
        MajicBot bot = member.bot();
        for (Parameter parameter : bot.parameters()) {
            if (parameter.readable() && !parameter.name().equals(AGE)) {
                sample(lines, parameter, read(bot, parameter));
            }
        }
        bot.displayState().forEach((name, text) -> report(lines, name, text));
        note(lines, Kind.STATUS, "connection", bot.connection().name().toLowerCase(Locale.ROOT));
        note(lines, Kind.STATUS, "placed", bot.placedAt().isPresent() ? "yes" : "");
        note(lines, Kind.STATUS, "owner", owner(member.owner()));
        note(
                lines,
                Kind.STATUS,
                "stop",
                VisibleText.of(stops.problem(robot.number()).orElse("")));
    }

    /** Makes only changed texts visible, because most stay the same. */
    private void report(StringBuilder lines, String name, String text) {
        if (!text.equals(reports.put(name, text))) {
            note(lines, Kind.REPORT, name, VisibleText.of(text));
        }
    }

    private static Value read(MajicBot bot, Parameter parameter) {
        try {
            return bot.get(parameter.name());
        } catch (BotException e) {
            return Value.unknown(String.valueOf(e.getMessage()));
        }
    }

    private void sample(StringBuilder lines, Parameter parameter, Value value) {
        Value before = values.put(parameter.name(), value);
        if (value.equals(before)) {
            return;
        }
        boolean about = isAbout(value);
        if (before == null || about != isAbout(before)) {
            lines.append(RecordingFormat.parameter(robot.number(), parameter, about));
        }
        note(lines, Kind.VALUE, parameter.name(), ValueText.of(value));
    }

    private static boolean isAbout(Value value) {
        return value instanceof Value.Many many
                ? many.values().stream().anyMatch(RobotSampler::isAbout)
                : value instanceof Value.Number number && number.about();
    }

    private void note(StringBuilder lines, Kind kind, String name, String text) {
        String before = texts.computeIfAbsent(kind, key -> new HashMap<>()).put(name, text);
        if (!text.equals(before)) {
            lines.append(RecordingFormat.change(kind, robot.number(), name, text));
        }
    }

    static String owner(@Nullable Owner owner) {
        return owner == null ? "" : VisibleText.of(owner.occupation());
    }
}
