package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.Test;

/** Types the first block of the page about going to places, in the lab that the page starts. */
class GoingToPlacesPageTest {
    private static final Page PAGE = Page.of("docs/going-to-places.md");

    @Test
    void theFiveMinutesInTheLabAreDone() throws Exception {
        try (LabRig lab = LabRig.of(office()).withAllRobots()) {
            MajicParser parser = MajicParser.pipe(lab.session());
            for (String line : PAGE.block("majic", "map open").lines()) {
                assertThat(parser.parseText(line)).as(line).isEmpty();
            }
            parser.awaitAll();
            assertThat(lab.said())
                    .noneMatch(line -> line.contains("failed"))
                    .anyMatch(line -> line.startsWith("2 goto desk: done"))
                    .anyMatch(line -> line.contains("Patrol: round 3, to desk"))
                    .anyMatch(line -> line.startsWith("4 goto -9000 -3000: done"));
        }
    }

    private static LabOptions office() throws IOException {
        return LabOptions.exactOnFreePorts()
                .withRoom(Room.load(Path.of("sims", "worlds", "office.map")))
                .withPioneer("p3dx-sh+laser")
                .withPioneers(2);
    }
}
