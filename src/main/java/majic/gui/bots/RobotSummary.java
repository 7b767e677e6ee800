package majic.gui.bots;

import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.MajicBot;
import majic.gui.acts.RunningAct;
import majic.gui.kit.BotStatus;
import majic.gui.kit.StateIcon;
import majic.team.Member;
import majic.team.Owner;
import majic.team.StopStatus;
import majic.text.Texts;

/**
 * What the card of a robot shows at one moment. Immutable.
 *
 * @param icon the sign of its state
 * @param name its name and type
 * @param condition whether it moves; if it is not connected, the state of its connection
 * @param problem what needs attention, in a few words; empty if nothing does
 * @param activity the name of the act, or what else owns or holds the robot; empty if nothing does
 * @param actTime the running time of the act; empty if none runs
 * @param battery its charge
 * @param bars the quality of its connection, 0 to 3
 * @param isLost whether it can be reconnected
 * @param isUnconfirmed whether its last stop was not confirmed
 */
record RobotSummary(
        StateIcon icon,
        String name,
        String condition,
        String problem,
        String activity,
        String actTime,
        BatteryLevel battery,
        int bars,
        boolean isLost,
        boolean isUnconfirmed) {
    private static final Texts TEXTS = Texts.of(RobotSummary.class);

    /**
     * Describes a robot as it is now.
     *
     * @param countdown when a lost robot is reconnected, in a few words; empty if nothing is tried
     */
    static RobotSummary of(
            Member member, StopStatus stops, RunningAct act, LinkMeter link, CardReadings readings, String countdown) {
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
                member.label(),
                connected ? motion(bot) : BotStatus.condition(member),
                problem(unconfirmed, lost, countdown, connected && readings.stopPressed())
                        .or(() -> overdue(link, now))
                        .orElse(""),
                act.now().map(Owner::name).orElseGet(() -> BotStatus.user(member)),
                act.now().map(owner -> act.time()).orElse(""),
                connected ? readings.battery() : BatteryLevel.UNKNOWN,
                connected ? link.bars(now) : 0,
                lost,
                unconfirmed);
    }

    private static String motion(MajicBot bot) {
        return TEXTS.get(bot.state().moving() ? "summary.moving" : "summary.stationary");
    }

    /** Returns the gravest problem, apart from reports that are overdue. */
    static Optional<String> problem(boolean unconfirmed, boolean lost, String countdown, boolean stopPressed) {
        if (unconfirmed) {
            return Optional.of(TEXTS.get("summary.unconfirmed"));
        }
        if (lost) {
            return Optional.of(
                    countdown.isEmpty() ? TEXTS.get("summary.lost") : TEXTS.get("summary.lost.retry", countdown));
        }
        return stopPressed ? Optional.of(TEXTS.get("summary.pressed")) : Optional.empty();
    }

    private static Optional<String> overdue(LinkMeter link, long nowNanos) {
        return link.overdueS(nowNanos).stream()
                .mapToObj(age -> TEXTS.get("summary.overdue", Math.round(Math.max(1, age))))
                .findFirst();
    }

    /** Returns the activity, followed by its running time if it has one. */
    private String timedActivity() {
        return actTime.isEmpty() ? activity : activity + "  " + actTime;
    }

    /** Returns the most important text of a card with room for one line beside the name. */
    String line() {
        return firstOf(problem, timedActivity(), condition);
    }

    /** Returns the most important text of a card with room for one line only. */
    String shortest() {
        return firstOf(problem, timedActivity(), name);
    }

    private static String firstOf(String... texts) {
        return Stream.of(texts).filter(text -> !text.isEmpty()).findFirst().orElse("");
    }

    /** Returns all as one line, for screen readers and the tool tip. */
    String description() {
        Optional<String> charge = Optional.of(battery.text()).filter(text -> !text.isEmpty());
        return Stream.of(
                        name,
                        condition,
                        problem,
                        timedActivity(),
                        charge.map(text -> TEXTS.get("summary.battery", text)).orElse(""))
                .filter(text -> !text.isEmpty())
                .distinct()
                .collect(Collectors.joining(", "));
    }
}
