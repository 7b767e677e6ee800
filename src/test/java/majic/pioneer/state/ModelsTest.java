package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.Pose;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelsTest {
    private static final double SONARS_STAND_OUT_MM = 20;

    @Test
    void theHullOfAP3DxLiesAsInTheSheet() {
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

    /** Columns as the head of the table names them. */
    @ParameterizedTest(name = "{0}")
    @CsvFileSource(resources = "/majic/pioneer/state/models.csv")
    void everyRowOfTheTableIsTheModelThatIsDriven(ArgumentsAccessor row) {
        Model model = Models.of(row.getString(0));

        assertThat(model.known()).isTrue();
        assertThat(model.scaling())
                .isEqualTo(new Scaling(
                        row.getDouble(6),
                        360 / row.getDouble(12),
                        row.getDouble(7),
                        row.getDouble(8),
                        row.getDouble(9)));
        assertThat(List.of(model.topSpeedMmPerSec(), model.topTurnDegPerSec()))
                .isEqualTo(List.of(row.getDouble(4), row.getDouble(5)));
        assertThat(List.of(model.frontBumpers(), model.rearBumpers()))
                .isEqualTo(List.of(row.getInteger(10), row.getInteger(11)));
        assertThat(model.hull().halfWidthMm() * 2).isEqualTo(row.getDouble(3));
        assertThat(model.hull().frontMm() + model.hull().rearMm())
                .isBetween(row.getDouble(2), row.getDouble(2) + SONARS_STAND_OUT_MM);
    }

    @ParameterizedTest(name = "{0}")
    @CsvFileSource(resources = "/majic/pioneer/state/models.csv")
    void everyModelsCountsBecomeMillimetresByItsOwnFactors(ArgumentsAccessor row) {
        StateTracker tracker = new StateTracker(Models.of(row.getString(0)), Pose.START);
        tracker.track(new SipBytes().pose(0, 0, 0).sip(), 1);
        PioneerState state = tracker.track(
                new SipBytes().pose(1000, 0, 0).wheels(-100, 300).sonar(0, 1000).sip(), 2);

        assertThat(state.pose().xMm()).isCloseTo(1000 * row.getDouble(6), within(1e-9));
        assertThat(state.speedMmPerSec()).isCloseTo(100 * row.getDouble(7), within(1e-9));
        assertThat(Math.toRadians(state.turnRateDegPerSec()))
                .isCloseTo(200 * row.getDouble(7) * row.getDouble(9), within(1e-9));
        assertThat(state.sonar().rangeMm(0)).isEqualTo((int) Math.round(1000 * row.getDouble(8)));
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

    /** Facts of the maker's parameter files. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "powerbot, 0.5813, 4096, 1",
        "p2pb, 0.424, 4096, 1",
        "p2at8+, 0.465, 4096, 1",
        "p2pp, 0.485, 4096, 1",
        "perfpb, 0.485, 4096, 1",
        "perfpb+, 0.485, 4096, 1",
        "p2df, 0.485, 4096, 1",
        "p2d8+, 0.485, 4096, 1",
        "p2it, 1.136, 4096, 1",
        "pion1m, 0.05066, 1024, 2.5332",
        "pion1x, 0.05066, 1024, 2.5332",
        "psos1m, 0.05066, 1024, 2.5332",
        "psos1x, 0.05066, 1024, 2.5332",
        "psos43m, 0.05066, 1024, 2.5332",
        "pionat, 0.07, 1024, 2.5332",
        "amigo-sh-tim3xx, 1, 4096, 1",
        "researchPB, 1, 4096, 1",
        "researchPB-lms500, 1, 4096, 1",
        "mt400, 1, 4096, 1",
        "pioneer-lx-ld, 1, 4096, 1",
        "powerbot-sh-uarcs, 1, 4096, 1",
        "wheelchair-sh, 1, 4096, 1"
    })
    void olderAndRarerModelsHaveTheirOwnScale(String subclass, double mm, double counts, double speed) {
        Model model = Models.of(subclass);

        assertThat(model.known()).isTrue();
        assertThat(model.scaling().mmPerCount()).isEqualTo(mm);
        assertThat(model.scaling().countsPerTurn()).isEqualTo((int) counts);
        assertThat(model.scaling().mmPerSecPerCount()).isEqualTo(speed);
    }

    @Test
    void theAmigoBotWithALaserHasItsSpeedAndSonars() {
        assertThat(Models.of("amigo-sh-tim3xx")).isEqualTo(Models.of("amigo-sh"));
        assertThat(Models.of("researchPB").discs())
                .isEqualTo(Models.of("patrolbot-sh").discs());
    }

    @ParameterizedTest
    @ValueSource(strings = {"p9xx", ""})
    void anUnknownModelIsDrivenCarefully(String subclass) {
        Model model = Models.of(subclass);

        assertThat(model.known()).isFalse();
        assertThat(Ramps.careful(Limits.of(model, null)).topSpeedMmPerSec()).isEqualTo(300);
        assertThat(Ramps.careful(Limits.of(model, null)).topTurnDegPerSec()).isEqualTo(50);
    }

    @Test
    void reportedLimitsReduceThoseOfTheModel() {
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
