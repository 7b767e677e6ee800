package majic.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class NumberListTest {
    @Test
    void fewNumbersAreListedOneByOne() {
        assertThat(NumberList.of(List.of(1, 2, 3, 7))).isEqualTo("1, 2, 3, 7");
        assertThat(NumberList.of(List.of())).isEmpty();
    }

    @Test
    void numbersThatFollowEachOtherAreARange() {
        assertThat(NumberList.of(IntStream.rangeClosed(1, 200).boxed().toList()))
                .isEqualTo("1–200");
        assertThat(NumberList.of(List.of(1, 3, 4, 5, 6, 9))).isEqualTo("1, 3–6, 9");
    }
}
