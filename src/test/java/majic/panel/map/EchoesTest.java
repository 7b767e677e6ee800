package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.panel.map.Echoes.Echo;
import org.junit.jupiter.api.Test;

class EchoesTest {
    private final Echoes echoes = new Echoes();

    @Test
    void aNewEchoTakesThePlaceOfTheOneBeforeInItsSquare() {
        echoes.add(new Echo(1000, 2000, 1));
        echoes.add(new Echo(3000, 0, 2));
        echoes.add(new Echo(1005, 2005, 3));

        assertThat(echoes.all()).extracting(Echo::atNanos).containsExactly(2L, 3L);
    }

    @Test
    void theOldestGoFirstWhenThereAreTooMany() {
        for (int count = 1; count <= 5000; count++) {
            echoes.add(new Echo(count * 50, -count * 50, count));
        }
        assertThat(echoes.all()).hasSize(3000);
        assertThat(echoes.all().get(0).atNanos()).isEqualTo(2001);
    }

    @Test
    void whatWasTakenDoesNotChange() {
        echoes.add(new Echo(0, 0, 1));
        List<Echo> before = echoes.all();

        echoes.clear();

        assertThat(before).hasSize(1);
        assertThat(echoes.all()).isEmpty();
    }
}
