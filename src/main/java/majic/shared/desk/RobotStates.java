package majic.shared.desk;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.RangeSensor;
import majic.bot.Value;
import majic.shared.message.Description;
import majic.shared.message.RobotState;
import majic.shared.message.Sender;
import majic.shared.message.ValueJson;
import majic.team.Member;
import majic.team.Owner;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** Describes a robot for others: what it is, and what it does now. Asks the robot nothing and waits for nothing. */
final class RobotStates {
    private RobotStates() {}

    static Description description(Member member, Sender desk) {
        MajicBot bot = member.bot();
        return new Description(
                desk.session(),
                member.name(),
                new Description.Kind(
                        bot.type().name(), bot.type().label(), bot.type().make()),
                bot.introduction(),
                bot.profile(),
                bot.hasCamera(),
                bot.calibration(),
                bot.parameters(),
                bot.commands(),
                sensors(bot));
    }

    private static List<RangeSensor> sensors(MajicBot bot) {
        List<RangeSensor> known = new ArrayList<>();
        WaitPolicy.without(() -> known.addAll(bot.rangeSensors()));
        return known;
    }

    /**
     * Describes the present state.
     *
     * @param clockMs the clock of the desk
     * @param latched whether STOP is latched
     * @param stops how often the robot was stopped
     * @param hold the hold of another desk; null without one
     */
    static RobotState state(
            Member member,
            Sender desk,
            long clockMs,
            boolean latched,
            long stops,
            @Nullable RobotHold hold,
            Optional<String> stopProblem) {
        MajicBot bot = member.bot();
        return new RobotState(
                clockMs,
                new RobotState.Link(bot.connection(), bot.lostReason().orElse("")),
                movement(bot),
                latched,
                stops,
                holder(member, desk, hold),
                stopProblem.orElse(null),
                values(bot));
    }

    /** The pose and the origin are of the same moment, though the robot may be placed meanwhile. */
    private static RobotState.Movement movement(MajicBot bot) {
        Pose origin;
        BotState state;
        do {
            origin = bot.odometryOrigin();
            state = bot.state();
        } while (!origin.equals(bot.odometryOrigin()));
        return new RobotState.Movement(
                state.pose(),
                origin,
                bot.placedAt().isPresent(),
                state.speedMmPerSec(),
                state.turnRateDegPerSec(),
                state.moving(),
                Math.round(bot.time().secondsSince(state.atNanos()) * 1000));
    }

    /** An owner at this desk holds the robot in the name of the desk. */
    private static RobotState.@Nullable Holder holder(Member member, Sender desk, @Nullable RobotHold hold) {
        if (hold != null && !hold.hasEnded()) {
            Sender holder = hold.holder();
            return new RobotState.Holder(holder.desk(), holder.person(), holder.sessionHash(), "");
        }
        Owner owner = member.owner();
        return owner == null || owner.kind() == Owner.Kind.REMOTE
                ? null
                : new RobotState.Holder(desk.desk(), desk.person(), desk.sessionHash(), owner.occupation());
    }

    private static Map<String, JsonNode> values(MajicBot bot) {
        Map<String, JsonNode> values = new LinkedHashMap<>();
        WaitPolicy.observing(() -> bot.parameters().stream()
                .filter(parameter -> parameter.readable() && !RobotState.NOT_IN_VALUES.contains(parameter.name()))
                .forEach(parameter -> values.put(parameter.name(), ValueJson.of(read(bot, parameter)))));
        return values;
    }

    private static Value read(MajicBot bot, Parameter parameter) {
        try {
            return bot.get(parameter.name());
        } catch (BotException e) {
            return Value.unknown(String.valueOf(e.getMessage()));
        }
    }
}
