package majic.shared.message;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

/** Tests what is published between two states of a shared robot. */
class StateChangeTest {
    private static final Map<String, JsonNode> VALUES =
            Map.of("voltage", ValueJson.of(Value.of(12.6, Unit.V)), "bumped", ValueJson.of(Value.yesNo(false)));

    private static RobotState state(long clock, double xMm, long stops, Map<String, JsonNode> values) {
        return new RobotState(
                clock,
                new RobotState.Link(Connection.CONNECTED, ""),
                new RobotState.Movement(new Pose(xMm, 2, 3), Pose.START, true, xMm / 10, 5, true, 6),
                false,
                stops,
                null,
                null,
                values);
    }

    private static Map<String, JsonNode> bumped() {
        return Map.of("voltage", ValueJson.of(Value.of(12.6, Unit.V)), "bumped", ValueJson.of(Value.yesNo(true)));
    }

    @Test
    void aStateWithTheChangeToALaterOneIsTheLaterOne() {
        RobotState before = state(100, 0, 0, VALUES);
        RobotState later = state(200, 30, 0, bumped());

        StateChange change =
                StateChange.parse(StateChange.between(before, later).toJson());

        assertThat(before.with(change)).isEqualTo(later);
    }

    @Test
    void aChangeHasOnlyTheValuesThatDiffer() {
        StateChange change = StateChange.between(state(100, 0, 0, VALUES), state(200, 0, 0, bumped()));

        assertThat(new String(change.toJson(), java.nio.charset.StandardCharsets.UTF_8))
                .isEqualTo("{\"clock\":200,\"age\":6,\"values\":{\"bumped\":true}}");
    }

    @Test
    void aRobotThatRepeatsItsReportHasNoChange() {
        assertThat(StateChange.between(state(100, 0, 0, VALUES), state(200, -0.001, 0, VALUES))
                        .isEmpty())
                .isTrue();
        assertThat(StateChange.between(state(100, 0, 0, VALUES), state(200, 0.01, 0, VALUES))
                        .isEmpty())
                .isFalse();
    }

    @Test
    void aConditionOrAnotherParameterIsNoMereChange() {
        RobotState before = state(100, 0, 0, VALUES);

        assertThat(state(200, 30, 0, bumped()).hasConditionsOf(before)).isTrue();
        assertThat(state(200, 0, 1, VALUES).hasConditionsOf(before)).isFalse();
        assertThat(state(200, 0, 0, Map.of()).hasConditionsOf(before)).isFalse();
    }
}
