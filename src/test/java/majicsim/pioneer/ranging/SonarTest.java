package majicsim.pioneer.ranging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SonarTest {
    private static final int SONAR = 28;

    @Test
    void aSipCarriesOnlyTheFewNewReadingsOfEachArray() {
        Rig rig = Rig.open();
        Map<Integer, Integer> seen = new TreeMap<>();
        for (SipView sip : rig.step(0.8).sips()) {
            assertThat(sip.sonar().keySet().stream().filter(disc -> disc < 8).count())
                    .isBetween(2L, 3L);
            assertThat(sip.sonar().keySet().stream().filter(disc -> disc >= 8).count())
                    .isBetween(2L, 3L);
            sip.sonar().keySet().forEach(disc -> seen.merge(disc, 1, Integer::sum));
        }
        assertThat(seen).hasSize(16);
        assertThat(seen.values()).allSatisfy(times -> assertThat(times).isBetween(2, 3));
    }

    @Test
    void switchedOffItIsSilentAndTheFlagsShowIt() {
        Rig rig = Rig.open().command(SONAR, 0);
        assertThat(rig.nextSip().sonar()).isEmpty();
        assertThat(rig.nextSip().flags()).isZero();
        rig.command(SONAR, 1);
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E);
        assertThat(rig.nextSip().sonar()).isNotEmpty();
    }

    @Test
    void oneArrayCanBeSwitchedAlone() {
        Rig rig = Rig.open().command(SONAR, 2 << 1);
        rig.nextSip();
        assertThat(rig.nextSip().flags()).isEqualTo(0x1A);
        assertThat(rig.nextSip().sonar().keySet()).allMatch(disc -> disc < 8);
        assertThat(rig.command(SONAR, 5 << 1).command(SONAR, -5).nextSip().flags())
                .isEqualTo(0x1A);
    }

    @ParameterizedTest
    @CsvSource({"0, 3864", "3, 4834", "4, 4834", "7, 3864", "11, 4745", "15, 3864"})
    void aWallIsMeasuredAtItsDistanceFromTheDisc(int disc, int range) {
        assertThat(allReadings(Rig.open()))
                .hasEntrySatisfying(disc, heard -> assertThat(heard).isBetween(range, range + 5));
    }

    @Test
    void anEchoFromAWallMetAtASlantIsLost() {
        Map<Integer, Integer> readings =
                allReadings(new Rig(new Pose(0, -3000, 0), Noise.exact(), "p3dx-sh").shakeHands());
        assertThat(readings.get(7)).isEqualTo(864);
        assertThat(readings.get(4)).isGreaterThan(4500);
    }

    @Test
    void anotherRobotsCornerIsMeasuredWhateverItsDirection() {
        Rig rig = Rig.silent();
        rig.world.add(Body.box("other", 200, 200, 200, new Pose(1200, 0, 45)));
        double corner = 1200 - 200 * Math.sqrt(2) - 166;
        Map<Integer, Integer> readings = allReadings(rig.shakeHands());
        assertThat(readings.get(3).doubleValue()).isCloseTo(corner, within(10.0));
        assertThat(readings.get(4).doubleValue()).isCloseTo(corner, within(10.0));
    }

    @Test
    void rangesAreOffByAboutOnePercentWithNoise() {
        Rig rig = new Rig(new Pose(0, 0, 0), Noise.seeded(7), "p3dx-sh").shakeHands();
        double[] errors = rig.pulse(30).sips().stream()
                .filter(sip -> sip.sonar().containsKey(0))
                .mapToDouble(sip -> sip.sonar().get(0) / 3864.0 - 1)
                .toArray();
        double sigma = Math.sqrt(Arrays.stream(errors).map(e -> e * e).average().orElseThrow());
        assertThat(sigma).isBetween(0.005, 0.015);
    }

    @Test
    void noEchoIsExactlyFiveThousandNoiseOrNot() {
        Rig rig = new Rig(new Pose(-4000, 0, 0), Noise.seeded(7), "p3dx-sh").shakeHands();
        assertThat(allReadings(rig)).containsEntry(3, 5000);
    }

    private static Map<Integer, Integer> allReadings(Rig rig) {
        Map<Integer, Integer> readings = new TreeMap<>();
        rig.step(0.4).sips().forEach(sip -> readings.putAll(sip.sonar()));
        return readings;
    }
}
