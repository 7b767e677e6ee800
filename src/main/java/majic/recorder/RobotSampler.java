package majic.recorder;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import majic.recorder.RecordingFormat.Kind;
import majic.team.Member;
import majic.team.Owner;
import majic.team.StopStatus;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Finds what has changed of one robot since the last time: its parameters, the reports that its panel needs, what the
 * team keeps of it. Sends the robot nothing, except that it asks for scans, and waits for nothing. Samples are taken by
 * one thread.
 */
final class RobotSampler {
    /** Changes all the time and follows from the times of the other values. */
    private static final String AGE = "age";

    /** How often a robot that reports nothing is sampled: its owner and its settings may change. */
    private static final double QUIET_PERIOD_S = 0.5;

    private static final double WAY_PERIOD_S = 0.5;

    private final Member member;
    private final RecordedRobot robot;
    private List<Parameter> described = List.of();
    private List<Sampled> samples = List.of();
    private final Map<Kind, Map<String, String>> texts = new EnumMap<>(Kind.class);
    private final Map<String, String> reports = new HashMap<>();
    private final ScanSampler scans;
    private final Supplier<List<Pose>> way;
    private volatile boolean forgotten = true;
    private volatile boolean reported = true;
    private double sampledS = Double.NEGATIVE_INFINITY;
    private double wayS = Double.NEGATIVE_INFINITY;

    /**
     * Creates a sampler.
     *
     * @param way the way on which the robot drives to a place, the point where it is first; empty if it does not
     */
    RobotSampler(Member member, RecordedRobot robot, Supplier<List<Pose>> way) {
        this.member = member;
        this.robot = robot;
        this.way = way;
        this.scans = new ScanSampler(robot.number(), member.bot());
    }

    /** Describes everything anew the next time. Called by any thread. */
    void forget() {
        forgotten = true;
    }

    /** The robot has reported something. Called by any thread. */
    void reported() {
        reported = true;
    }

    /** Asks the robot for nothing any more. Called by any thread. */
    void end() {
        scans.end();
    }

    /** Adds a line for each change, if the robot has reported something or was not sampled for a while. */
    void sample(StringBuilder lines, StopStatus stops, double nowS) {
        if (reported || forgotten || nowS - sampledS >= QUIET_PERIOD_S) {
            reported = false;
            sampledS = nowS;
            sample(lines, stops);
        }
        scans.sample(lines, nowS);
    }

    private void sample(StringBuilder lines, StopStatus stops) {
        if (forgotten) {
            forgotten = false;
            samples.forEach(sampled -> sampled.last = null);
            texts.clear();
            reports.clear();
            scans.forget();
            wayS = Double.NEGATIVE_INFINITY;
            lines.append(RecordingFormat.robot(robot));
        }
        MajicBot bot = member.bot();
        for (Sampled sampled : sampled(bot.parameters())) {
            sample(lines, sampled, read(bot, sampled.parameter));
        }
        bot.displayState().forEach((name, text) -> report(lines, name, text));
        note(lines, Kind.STATUS, "connection", bot.connection().name().toLowerCase(Locale.ROOT));
        note(lines, Kind.STATUS, "placed", bot.placedAt().isPresent() ? "yes" : "");
        note(lines, Kind.STATUS, RecordingFormat.AIRCRAFT, bot.profile().leavesGround() ? "yes" : "");
        note(lines, Kind.STATUS, "owner", owner(member.owner()));
        note(
                lines,
                Kind.STATUS,
                "stop",
                VisibleText.of(stops.problem(robot.number()).orElse("")));
        if (sampledS - wayS >= WAY_PERIOD_S) {
            wayS = sampledS;
            List<Pose> ahead = way.get().stream().skip(1).toList();
            note(lines, Kind.STATUS, RecordingFormat.WAY, RecordingFormat.way(ahead));
        }
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

    /** Returns the parameters that are recorded; a robot usually returns the same list at each sample. */
    private List<Sampled> sampled(List<Parameter> present) {
        if (present != described) {
            Map<String, Value> known = new HashMap<>();
            samples.forEach(sample -> known.put(sample.parameter.name(), sample.last));
            samples = present.stream()
                    .filter(parameter ->
                            parameter.readable() && !parameter.name().equals(AGE))
                    .map(parameter -> new Sampled(parameter, known.get(parameter.name())))
                    .toList();
            described = present;
        }
        return samples;
    }

    private void sample(StringBuilder lines, Sampled sampled, Value value) {
        Value before = sampled.last;
        if (value.equals(before)) {
            return;
        }
        sampled.last = value;
        boolean about = isAbout(value);
        if (before == null || about != isAbout(before)) {
            lines.append(RecordingFormat.parameter(robot.number(), sampled.parameter, about));
        }
        note(lines, Kind.VALUE, sampled.parameter.name(), ValueText.of(value));
    }

    /** A parameter with the value that was recorded last. */
    private static final class Sampled {
        private final Parameter parameter;
        private @Nullable Value last;

        Sampled(Parameter parameter, @Nullable Value last) {
            this.parameter = parameter;
            this.last = last;
        }
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
