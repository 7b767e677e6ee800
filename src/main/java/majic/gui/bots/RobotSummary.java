package majic.gui.bots;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.MajicBot;
import majic.gui.acts.RunningAct;
import majic.gui.kit.BotStatus;
import majic.gui.kit.StateIcon;
import majic.panel.BatteryIcon;
import majic.team.Member;
import majic.team.Owner;
import majic.team.StopStatus;
import majic.text.Texts;

/**
 * What the tab of a robot shows at one moment. Immutable.
 *
 * @param icon the sign of its state
 * @param make its make
 * @param names its name and type, in wordings from the longest to the shortest
 * @param condition whether it moves; if it is not connected, the state of its connection
 * @param problem what needs attention, in wordings from the longest to the shortest, which is never shortened to what
 *     could be read as something else: it is empty if the icon is a sign of the problem, otherwise a sign; no wordings
 *     if nothing needs attention
 * @param activity the name of the act, or what else owns or holds the robot; empty if nothing does
 * @param actTime the running time of the act; empty if none runs
 * @param battery its charge
 * @param bars the quality of its connection, 0 to 3; empty if it has none or it is not measured
 * @param isLost whether it can be reconnected
 * @param isUnconfirmed whether its last stop was not confirmed
 */
public record RobotSummary(
        StateIcon icon,
        String make,
        List<String> names,
        String condition,
        List<String> problem,
        String activity,
        String actTime,
        BatteryLevel battery,
        OptionalInt bars,
        boolean isLost,
        boolean isUnconfirmed) {
    private static final Texts TEXTS = Texts.of(RobotSummary.class);

    /** Stands for a problem where there is no room for a word. */
    private static final String SIGN = "!";

    public RobotSummary {
        names = List.copyOf(names);
        problem = List.copyOf(problem);
    }

    /**
     * Describes a robot as it is now.
     *
     * @param countdown when a lost robot is reconnected, in a few words; empty if nothing is tried
     */
    static RobotSummary of(
            Member member,
            StopStatus stops,
            RunningAct act,
            LinkMeter link,
            SummaryReadings readings,
            String countdown) {
        MajicBot bot = member.bot();
        boolean unconfirmed = stops.problem(member.number()).isPresent();
        boolean connected = bot.isConnected();
        if (connected) {
            link.reported(bot.state().atNanos());
        } else {
            link.clear();
        }
        long now = member.time().nanos();
        boolean lost = bot.connection() == MajicBot.Connection.LOST;
        return new RobotSummary(
                StateIcon.of(member, stops),
                bot.type().make(),
                member.name().isEmpty() ? List.of(member.label()) : List.of(member.label(), member.name()),
                connected ? motion(bot.state().moving()) : BotStatus.condition(member),
                problem(unconfirmed, lost, countdown, connected && readings.stopPressed())
                        .or(() -> overdue(link, now))
                        .orElse(List.of()),
                act.now().map(Owner::name).orElseGet(() -> BotStatus.user(member)),
                act.now().map(owner -> act.time()).orElse(""),
                connected ? readings.battery() : BatteryLevel.UNKNOWN,
                connected ? OptionalInt.of(link.bars(now)) : OptionalInt.empty(),
                lost,
                unconfirmed);
    }

    /** Returns the word for a connected robot that moves, or for one that does not. */
    public static String motion(boolean moving) {
        return TEXTS.get(moving ? "summary.moving" : "summary.stationary");
    }

    /** Returns the wordings of the gravest problem, apart from reports that are overdue. */
    public static Optional<List<String>> problem(
            boolean unconfirmed, boolean lost, String countdown, boolean stopPressed) {
        if (unconfirmed) {
            return Optional.of(List.of(TEXTS.get("summary.unconfirmed"), TEXTS.get("summary.unconfirmed.short"), ""));
        }
        if (lost) {
            return Optional.of(lost(countdown));
        }
        return stopPressed
                ? Optional.of(List.of(TEXTS.get("summary.pressed"), TEXTS.get("summary.pressed.short"), SIGN))
                : Optional.empty();
    }

    private static List<String> lost(String countdown) {
        String longest = countdown.isEmpty() ? TEXTS.get("summary.lost") : TEXTS.get("summary.lost.retry", countdown);
        return List.of(longest, TEXTS.get("summary.lost.short"), "");
    }

    private static Optional<List<String>> overdue(LinkMeter link, long nowNanos) {
        return link.overdueS(nowNanos).stream()
                .mapToLong(age -> Math.round(Math.max(1, age)))
                .mapToObj(age -> List.of(
                        TEXTS.get("summary.overdue", age), TEXTS.get("summary.overdue.short", age), age + " s", SIGN))
                .findFirst();
    }

    /** Returns the activity, followed by its running time if it has one. */
    private String timedActivity() {
        return actTime.isEmpty() ? activity : activity + "  " + actTime;
    }

    /** Returns the wordings for a line beside a line with the activity. */
    List<String> conditionLine() {
        return firstOf(Stream.of(problem, List.of(condition)));
    }

    /** Returns the wordings for the only line beside the name. */
    List<String> line() {
        return firstOf(Stream.of(problem, wordings(timedActivity()), List.of(condition)));
    }

    /** Returns the wordings for the only line. */
    List<String> onlyLine() {
        return firstOf(Stream.of(problem, lowBattery(), wordings(timedActivity()), names));
    }

    private List<String> lowBattery() {
        boolean low = battery.percent().orElse(100) < BatteryIcon.LOW_PERCENT;
        return low ? List.of(batteryText(), battery.text()) : List.of();
    }

    private String batteryText() {
        return TEXTS.get("summary.battery", battery.text());
    }

    private static List<String> wordings(String text) {
        return text.isEmpty() ? List.of() : List.of(text);
    }

    private static List<String> firstOf(Stream<List<String>> wordings) {
        return wordings.filter(texts -> !texts.isEmpty()).findFirst().orElse(List.of(""));
    }

    /** Returns all but the make as one line, for screen readers and the tool tip. */
    String description() {
        return Stream.of(
                        names.get(0),
                        condition,
                        problem.isEmpty() ? "" : problem.get(0),
                        timedActivity(),
                        battery.text().isEmpty() ? "" : batteryText())
                .filter(text -> !text.isEmpty())
                .distinct()
                .collect(Collectors.joining(", "));
    }
}
