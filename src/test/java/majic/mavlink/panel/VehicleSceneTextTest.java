package majic.mavlink.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.mavlink.panel.VehicleScene.Attitude;
import majic.mavlink.panel.VehicleScene.Echo;
import majic.mavlink.panel.VehicleScene.Echoes;
import majic.mavlink.panel.VehicleScene.Message;
import majic.mavlink.panel.VehicleScene.Severity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VehicleSceneTextTest {
    private static final long NANOS = 7;

    @Test
    void whatIsRecordedIsReadAgain() {
        VehicleScene scene = new VehicleScene(
                Optional.of(new Attitude(-3, 4, 271, true)),
                List.of("HOLD", "RTL"),
                Optional.of(new Echoes(List.of(new Echo(1200, -340), new Echo(0, 50)), NANOS)),
                List.of(
                        new Message(Severity.ERROR, "Arm: Accels inconsistent", Double.NaN),
                        new Message(Severity.INFO, "ArduRover V4.6.0", Double.NaN)),
                Optional.of(true));

        assertThat(VehicleSceneText.parse(VehicleSceneText.of(scene), NANOS)).contains(scene);
    }

    @Test
    void aVehicleThatHasReportedNothingIsReadAgain() {
        VehicleScene scene =
                new VehicleScene(Optional.empty(), List.of(), Optional.empty(), List.of(), Optional.of(false));
        assertThat(VehicleSceneText.parse(VehicleSceneText.of(scene), NANOS)).contains(scene);
    }

    @Test
    void aMessageCannotEndInTheMiddle() {
        VehicleScene scene = new VehicleScene(
                Optional.empty(),
                List.of(),
                Optional.empty(),
                List.of(new Message(Severity.WARNING, "a|b", Double.NaN)),
                Optional.empty());
        assertThat(VehicleSceneText.parse(VehicleSceneText.of(scene), NANOS)
                        .orElseThrow()
                        .messages())
                .containsExactly(new Message(Severity.WARNING, "a/b", Double.NaN));
    }

    @Test
    void ofAFailsafeThatWasNotRecordedNothingIsKnown() {
        assertThat(VehicleSceneText.parse(Map.of("attitude", ""), NANOS)
                        .orElseThrow()
                        .failsafe())
                .isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "1 2 x true", "1 2"})
    void aDamagedTextIsNoScene(String attitude) {
        assertThat(VehicleSceneText.parse(Map.of("attitude", attitude), NANOS)).isEmpty();
    }

    @Test
    void withoutARecordedSceneThereIsNone() {
        assertThat(VehicleSceneText.parse(Map.of("mode", "HOLD"), NANOS)).isEmpty();
    }
}
