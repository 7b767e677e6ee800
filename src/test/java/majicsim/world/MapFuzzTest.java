package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;

/** Arbitrary maps: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class MapFuzzTest {
    private static final double FARTHEST_MM = 1_000_000;

    /** The corner of a turned box may be farther away than its coordinates. */
    private static final double FARTHEST_CORNER_MM = 2 * FARTHEST_MM;

    @FuzzTest
    void anyMapIsReadOrRefusedWithItsPlace(byte[] text) {
        try {
            Room room = Room.parse(new StringReader(new String(text, StandardCharsets.ISO_8859_1)), "odd.map");
            assertThat(room.walls()).allMatch(MapFuzzTest::isInReach);
            assertThat(rays(room)).allMatch(hit -> hit.distanceMm() >= 0 && hit.distanceMm() <= FARTHEST_MM);
        } catch (IOException e) {
            assertThat(e.getMessage()).matches("odd\\.map:\\d+: \\P{Cntrl}+");
        }
    }

    private static List<Hit> rays(Room room) {
        World world = new World(room);
        Body viewer = Body.disc("viewer", 100, new Pose(0, 0, 0));
        return IntStream.range(0, 12)
                .mapToObj(twelfth -> world.ray(viewer, 0, 0, 30 * twelfth, FARTHEST_MM))
                .toList();
    }

    private static boolean isInReach(Segment wall) {
        return Math.abs(wall.x1()) <= FARTHEST_CORNER_MM
                && Math.abs(wall.y1()) <= FARTHEST_CORNER_MM
                && Math.abs(wall.x2()) <= FARTHEST_CORNER_MM
                && Math.abs(wall.y2()) <= FARTHEST_CORNER_MM;
    }
}
