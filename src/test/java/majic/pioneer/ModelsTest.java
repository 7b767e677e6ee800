package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Packet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModelsTest {

    @Test
    void theHullOfAP3DxLiesAsTheSheetSays() {
        Hull hull = Models.of("P3DX-SH").hull();

        assertThat(hull.frontMm()).isBetween(209.0, 212.0);
        assertThat(hull.rearMm()).isBetween(299.0, 302.0);
        assertThat(hull.halfWidthMm()).isEqualTo(212.5);
    }

    @Test
    void factorsDifferBetweenModels() {
        assertThat(Models.of("p3dx").scaling().mmPerCount()).isEqualTo(0.485);
        assertThat(Models.of("p3dx-sh").scaling().mmPerCount()).isEqualTo(1);
        assertThat(Models.of("p2de").scaling().mmPerRangeCount()).isEqualTo(0.268);
        assertThat(Models.of("amigo").scaling().mmPerSecPerCount()).isEqualTo(0.6154);
    }

    @Test
    void laserVariantsAreThePlainModel() {
        assertThat(Models.of("pioneer-lx-lms500")).isEqualTo(Models.of("pioneer-lx"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "P3DX-SH",
                "p3dx-sh-lms1xx",
                "p3at-sh-lms500",
                "p3at-sh-LMS1XX",
                " amigo-sh ",
                "seekurjr",
                "pioneer-lx-lms500",
                "p2at8"
            })
    void spellingsAndLasersMakeNoOtherModel(String subclass) {
        assertThat(Models.of(subclass).known()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "p2df",
                "p2d8+",
                "p2at8+",
                "p2it",
                "p2pb",
                "p2pp",
                "perfpb",
                "perfpb+",
                "pion1m",
                "pion1x",
                "pionat",
                "psos1m",
                "psos1x",
                "psos43m",
                "powerbot",
                "wheelchair-sh",
                ""
            })
    void modelsOfWhichOnlyTheNameIsKnownAreDrivenCarefully(String subclass) {
        Model model = Models.of(subclass);

        assertThat(model.known()).isFalse();
        assertThat(Ramps.careful(Limits.of(model, null)).topSpeedMmPerSec()).isEqualTo(300);
        assertThat(Ramps.careful(Limits.of(model, null)).topTurnDegPerSec()).isEqualTo(50);
    }

    @Test
    void whatTheRobotSaysOfItselfLimitsItsModel() {
        Limits limits = Limits.of(Models.of("p3dx"), Config.decode(Bytes.packet(Bytes.CONFIG)));

        assertThat(limits.speedMmPerSec()).isEqualTo(2200);
        assertThat(limits.setTurnDegPerSec()).isEqualTo(150);
        assertThat(Ramps.careful(limits).topSpeedMmPerSec()).isEqualTo(1000);
        assertThat(Ramps.careful(limits).topTurnDegPerSec()).isEqualTo(100);
    }

    @Test
    void aControllerThatClaimsToHardlySpeedUpIsStillDescribed() {
        byte[] data = Bytes.packet(Bytes.CONFIG).data();
        data[24] = 5;
        data[25] = 0;
        Limits limits = Limits.of(Models.of("p3dx"), Config.decode(new Packet(Config.TYPE, data, 0, data.length)));

        assertThat(limits.accelerationMmPerSec2()).isEqualTo(Ramps.GENTLEST);
    }

    @Test
    void modelsWithoutSonarsAndWithThirtyTwoAreKnown() {
        assertThat(Models.of("seekur").discs()).isEmpty();
        assertThat(Models.of("peoplebot-sh").discs()).hasSize(32);
        assertThat(Models.of("powerbot-sh").discs()).hasSize(28);
    }

    @Test
    void anUnknownModelIsDrivenSlowlyAndWithoutDistances() {
        Model model = Models.of("p9xx");

        assertThat(model.known()).isFalse();
        assertThat(model.profile(Ramps.careful(Limits.of(model, null))).speed().max())
                .isLessThanOrEqualTo(300);
        assertThat(model.discs()).isEmpty();
    }
}
