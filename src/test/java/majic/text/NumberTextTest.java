package majic.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NumberTextTest {
    @Test
    void hasAMinusSignInsteadOfAHyphen() {
        assertThat(NumberText.of(-55)).isEqualTo("−55");
        assertThat(NumberText.of("-0.5 mm/s")).isEqualTo("−0.5 mm/s");
    }

    @Test
    void showsBothSigns() {
        assertThat(NumberText.signed(149.6)).isEqualTo("+150");
        assertThat(NumberText.signed(-149.6)).isEqualTo("−150");
    }

    @Test
    void hasNoSignAtZero() {
        assertThat(NumberText.signed(-0.4)).isEqualTo("0");
        assertThat(NumberText.signed(0.4)).isEqualTo("0");
    }
}
