package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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
