package majicsim.pioneer.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import majicsim.pioneer.ConfigView;
import majicsim.pioneer.PioneerRobot;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class PioneerModelTest {
    static List<String> models() {
        return PioneerRobot.models();
    }

    @ParameterizedTest
    @MethodSource("models")
    void everyModelConnectsDrivesAndReportsInItsOwnUnits(String subclass) {
        PioneerModel model = PioneerModel.of(subclass);
        Rig rig =
                new Rig(new Pose(0, 0, 0), Noise.exact(), subclass).shakeHands().command(4, 1);
        assertThat(new String(rig.line.take().get(2), StandardCharsets.ISO_8859_1))
                .contains("\0" + model.className() + "\0" + subclass + "\0");
        SipView sip = rig.command(11, 100).command(21, 20).step(1).nextSip();
        Scaling scaling = model.scaling();
        assertThat((sip.right() + sip.left()) / 2.0 * scaling.mmPerSecPerSpeedUnit())
                .isCloseTo(100, within(1.0));
        double difference = (sip.right() - sip.left()) / 2.0 * scaling.mmPerSecPerSpeedUnit();
        assertThat(Math.toDegrees(difference * scaling.radPerMm())).isCloseTo(20, within(1.0));
        assertThat(sip.x() * scaling.mmPerPositionUnit()).isCloseTo(rig.pose().xMm(), within(2.0));
    }

    @ParameterizedTest
    @CsvSource({"p3dx-sh, 16", "amigo-sh, 8", "peoplebot-sh, 32", "powerbot-sh, 28", "pioneer-lx, 4", "seekur, 0"})
    void onlyFittedDiscsAreThere(String subclass, int discs) {
        assertThat(PioneerModel.of(subclass).sonars()).hasSize(discs);
    }

    @Test
    void anUnknownModelIsRefusedWithTheKnownOnes() {
        assertThatThrownBy(() -> PioneerModel.of("p9zz"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("p9zz")
                .hasMessageContaining("p3at-sh, p3atiw-sh");
    }

    @Test
    void theUsualModelIsPlainAndCarriesWhatItsOwnerHasFitted() {
        ConfigView plain = Rig.open().config();
        assertThat(plain.numbers()).containsAllEntriesOf(Map.of("GRIPPER", 0, "CHARGER", 0, "HASGYRO", 0));
        assertThat(plain.numbers()).containsAllEntriesOf(Map.of("FRONTBUMPS", 0, "REARBUMPS", 0));
        ConfigView fitted = Rig.open("P3DX-SH+bumpers+Gripper+gyro+charger").config();
        assertThat(fitted.texts()).containsEntry("SUBCLASS", "p3dx-sh");
        assertThat(fitted.numbers()).containsAllEntriesOf(Map.of("GRIPPER", 1, "CHARGER", 1, "HASGYRO", 1));
        assertThat(fitted.numbers()).containsAllEntriesOf(Map.of("FRONTBUMPS", 5, "REARBUMPS", 5));
    }

    @Test
    void whatAModelHasAnywayIsNotFittedAgain() {
        PioneerModel powerbot = PioneerModel.of("powerbot-sh");
        assertThat(PioneerModel.of("powerbot-sh+charger+bumpers+gyro")).isEqualTo(powerbot);
    }

    @ParameterizedTest
    @ValueSource(strings = {"p3dx-sh+wings", "p3dx-sh+", "p3dx-sh++gyro"})
    void anUnknownExtraIsRefusedWithTheKnownOnes(String name) {
        assertThatThrownBy(() -> PioneerModel.of(name))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageEndingWith("'; known are gripper, gyro, charger, compass, laser, bumpers,"
                        + " nofrontsonar, norearsonar, nowatchdog, unlisted");
    }

    @Test
    void aFittedCompassShowsInTheSip() {
        assertThat(Rig.open("p3dx-sh+compass").nextSip().compass()).isNotZero();
        assertThat(Rig.open().nextSip().compass()).isZero();
    }
}
