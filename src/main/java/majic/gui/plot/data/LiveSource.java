package majic.gui.plot.data;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.recorder.RecordedHistory;
import majic.team.Member;
import majic.team.Team;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Provides the readings of a team's robots to plots: those that were recorded so far, and then new ones as they are
 * reported. Thread-safe.
 */
public final class LiveSource implements PlotSource {
    private static final double NANOS_PER_S = 1e9;

    private final Team team;
    private final long startNanos;
    private final MarkRecord marks;
    private final Map<Member, LiveReadings> readings = new ConcurrentHashMap<>();
    private final @Nullable Past past;

    /**
     * Creates a source, and begins to record marks. Its time is that of the recording; without one it begins now.
     *
     * @param history what was recorded before; null if nothing is recorded
     */
    public LiveSource(Team team, @Nullable RecordedHistory history) {
        this.team = team;
        this.startNanos = team.time().nanos() - (long) (recordedS(history) * NANOS_PER_S);
        this.marks = new MarkRecord(this::now);
        this.past = history == null ? null : new Past(history, this::now);
        team.addListener(marks);
        team.addCommandListener(marks);
    }

    private static double recordedS(@Nullable RecordedHistory history) {
        try {
            return history == null ? 0 : history.endS();
        } catch (IOException e) {
            return 0;
        }
    }

    @Override
    public List<Robot> robots() {
        return team.members().stream().map(LiveSource::robot).toList();
    }

    private static Robot robot(Member member) {
        List<Parameter> parameters =
                member.bot().parameters().stream().filter(Quantity::isPlottable).toList();
        return new Robot(member.number(), member.label(), parameters);
    }

    @Override
    public String nameOf(int robot) {
        return member(robot).map(Member::name).orElse("");
    }

    @Override
    public List<Quantity> quantities(int robot, String parameter) {
        return member(robot).map(member -> quantities(member, parameter)).orElse(List.of());
    }

    private static List<Quantity> quantities(Member member, String name) {
        try {
            Parameter parameter = member.bot().parameter(name);
            return Quantity.isPlottable(parameter)
                    ? Quantity.of(member.number(), parameter, presentValue(member, name))
                    : List.of();
        } catch (BotException e) {
            return List.of();
        }
    }

    private static Value presentValue(Member member, String parameter) {
        Value[] value = new Value[1];
        WaitPolicy.without(() -> {
            value[0] = member.bot().get(parameter);
        });
        return value[0];
    }

    private Optional<Member> member(int robot) {
        return team.members().stream()
                .filter(member -> member.number() == robot)
                .findFirst();
    }

    @Override
    public Feed feed(Quantity quantity, Samples samples) {
        Feed live = member(quantity.robot())
                .map(member ->
                        readings.computeIfAbsent(member, this::readingsOf).feed(quantity, samples))
                .orElse(() -> {});
        Past recorded = past;
        if (recorded != null) {
            recorded.read(quantity, samples, marks);
        }
        return live;
    }

    private LiveReadings readingsOf(Member member) {
        return new LiveReadings(member, nanos -> seconds(member, nanos));
    }

    /** Returns the time of a report; a robot with a clock of its own reports now. */
    private double seconds(Member member, long reportNanos) {
        return member.time() == team.time() ? (reportNanos - startNanos) / NANOS_PER_S : now();
    }

    @Override
    public double now() {
        return team.time().secondsSince(startNanos);
    }

    @Override
    public List<PlotMark> marks(double from, double to) {
        return marks.between(from, to);
    }
}
