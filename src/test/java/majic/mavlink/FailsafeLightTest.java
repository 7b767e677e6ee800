package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import majic.inlab.LaidOutPanel;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The light of a failsafe, by the heartbeats and texts of a scripted rover. */
class FailsafeLightTest {
    @AutoClose
    private final DrivenRover robot = new DrivenRover().ready();

    private final ScriptedRover rover = robot.rover;

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        LaidOutPanel.lookAsInTheProgram();
    }

    private StatusLight light() throws Exception {
        return (StatusLight) LaidOutPanel.of(robot.bot(), 900, 600).label("failsafe");
    }

    private String recorded() {
        Map<String, String> state = robot.bot().displayState();
        return state.get("failsafe");
    }

    @ParameterizedTest
    @CsvSource({"3, no failsafe, GOOD", "4, no failsafe, GOOD", "5, FAILSAFE, ALARM", "6, FAILSAFE, ALARM"})
    void itShowsTheStatusOfTheHeartbeat(int status, String words, Kind kind) throws Exception {
        rover.status = status;
        robot.pass(1.2);

        assertThat(light().getText()).isEqualTo(words);
        assertThat(light().kind()).isEqualTo(kind);
        assertThat(recorded()).isEqualTo(status >= 5 ? "true" : "false");
    }

    @Test
    void itIsGoneWhenTheStatusIsAgainWhatItWas() throws Exception {
        rover.status = 5;
        robot.pass(1.2);
        rover.status = 4;
        robot.pass(1.2);

        assertThat(light().getText()).isEqualTo("no failsafe");
        assertThat(recorded()).isEqualTo("false");
    }

    @Test
    void itIsNotKnownAnyMoreWhenOnlyHeartbeatsAreMissing() throws Exception {
        rover.status = 5;
        robot.pass(1.2);
        rover.heartless = true;
        robot.pass(3.5);

        assertThat(robot.bot().isConnected()).isTrue();
        assertThat(light().getText()).isEqualTo("failsafe?");
        assertThat(light().kind()).isEqualTo(Kind.QUIET);
        assertThat(recorded()).isEmpty();
    }

    @Test
    void aLostVehicleHasAGreyLight() throws Exception {
        rover.status = 5;
        robot.pass(1.2);
        robot.fallSilent();
        robot.pass(4);

        assertThat(robot.bot().isConnected()).isFalse();
        assertThat(light().isEnabled()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"GCS Failsafe Cleared", "PreArm: Radio failsafe on", "Throttle armed"})
    void otherTextsDoNotLightIt(String text) throws Exception {
        robot.pass(1.2);
        rover.text(text);
        robot.pass(0.005);

        assertThat(light().getText()).isEqualTo("no failsafe");
    }
}
