package majic.nav.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import javax.imageio.ImageIO;
import majic.bot.Pose;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MapFilesTest {
    private static final String YAML = "image: a.pgm\nresolution: 0.1\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
            + "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    private static final String PICTURE = "P2\n# three columns, two rows\n3 2\n255\n0 254 205\n254 254 0\n";

    @TempDir
    private Path folder;

    private NavigationMap read(String yaml, String picture) throws IOException {
        Files.writeString(folder.resolve("a.pgm"), picture);
        return MapFiles.read(Files.writeString(folder.resolve("a.yaml"), yaml));
    }

    private NavigationMap world(String text) throws IOException {
        return MapFiles.read(Files.writeString(folder.resolve("w.map"), text));
    }

    @Test
    void theFirstRowOfThePictureIsTheTopOfTheMap() throws IOException {
        OccupancyGrid grid = read(YAML, PICTURE).grid();

        assertThat(grid.stateAt(-950, 2150)).isEqualTo(State.OCCUPIED);
        assertThat(grid.stateAt(-850, 2150)).isEqualTo(State.FREE);
        assertThat(grid.stateAt(-750, 2150)).isEqualTo(State.UNKNOWN);
        assertThat(grid.stateAt(-750, 2050)).isEqualTo(State.OCCUPIED);
        assertThat(grid.stateAt(-650, 2050)).isEqualTo(State.UNKNOWN);
    }

    @Test
    void aTurnedOriginTurnsTheMap() throws IOException {
        OccupancyGrid grid =
                read(YAML.replace("2.0, 0.0", "2.0, 1.5707963"), PICTURE).grid();

        assertThat(grid.stateAt(-1150, 2050)).isEqualTo(State.OCCUPIED);
        assertThat(grid.centre(0, 1).headingDeg()).isCloseTo(90, within(0.001));
    }

    @Test
    void negateExchangesFreeAndOccupied() throws IOException {
        OccupancyGrid grid =
                read(YAML.replace("negate: 0", "negate: 1"), PICTURE).grid();

        assertThat(grid.state(0, 1)).isEqualTo(State.FREE);
        assertThat(grid.state(1, 1)).isEqualTo(State.OCCUPIED);
    }

    @Test
    void theThresholdsDecideWhatIsKnown() throws IOException {
        String grey = "P2 1 1 100 60\n";

        assertThat(read(YAML, grey).grid().state(0, 0)).isEqualTo(State.UNKNOWN);
        assertThat(read(YAML.replace("0.196", "0.45"), grey).grid().state(0, 0)).isEqualTo(State.FREE);
        assertThat(read(YAML.replace("0.65", "0.3"), grey).grid().state(0, 0)).isEqualTo(State.OCCUPIED);
    }

    @Test
    void theOriginMayBeAListOfLines() throws IOException {
        String yaml = YAML.replace("origin: [-1.0, 2.0, 0.0]", "origin:\n- -1.0\n- 2.0\n- 0.0");

        assertThat(read(yaml, PICTURE).grid().origin()).isEqualTo(new Pose(-1000, 2000, 0));
    }

    @Test
    void aWrittenGridIsReadAgain() throws IOException {
        OccupancyGrid grid = OccupancyGrid.of(
                new Pose(-400, 250, 30), 50, 7, 4, (column, row) -> column == row ? 1 : column == 6 ? Double.NaN : 0);
        Path yaml = folder.resolve("b.yaml");

        MapFiles.write(yaml, NavigationMap.of(grid));

        OccupancyGrid again = MapFiles.read(yaml).grid();
        assertThat(again.origin().distanceMm(grid.origin())).isLessThan(0.01);
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 7; column++) {
                assertThat(again.state(column, row)).isEqualTo(grid.state(column, row));
            }
        }
        assertThat(Files.readString(yaml)).contains("image: \"b.pgm\"", "resolution: 0.05");
    }

    @Test
    void forbiddenLinesAreWrittenBesidePlacesAndNotIntoTheGrid() throws IOException {
        NavigationMap map = world("2D-Map\nCairn: Goal 100 200 0 \"\" ICON \"door\"\n"
                + "Cairn: ForbiddenLine 0 0 0 \"\" ICON \"\" 100 250 900 250\n"
                + "Cairn: ForbiddenArea 0 0 0 \"\" ICON \"\" 200 300 -400 500\nLINES\n0 0 1000 0\n0 600 1000 600\n");
        Path yaml = folder.resolve("w.yaml");

        MapFiles.write(yaml, map);

        NavigationMap again = MapFiles.read(yaml);
        assertThat(again.forbidden()).isEqualTo(map.forbidden()).hasSize(5);
        assertThat(again.places()).isEqualTo(map.places());
        assertThat(again.grid().stateAt(500, 250)).isEqualTo(State.FREE);
        assertThat(again.with(map.grid())
                        .with(map.places().get(0))
                        .without("door")
                        .forbidden())
                .isEqualTo(map.forbidden());
    }

    @Test
    void moreForbiddenLinesThanCanBeReadAgainAreNotWritten() throws IOException {
        NavigationMap map = read(YAML, PICTURE);
        NavigationMap full = new NavigationMap(
                map.grid(),
                map.places(),
                Collections.nCopies(100_000, new NavigationMap.ForbiddenLine(0, 0, 1, 1)),
                map.home());

        assertThatThrownBy(() -> MapFiles.write(folder.resolve("full.yaml"), full))
                .hasMessage("full.yaml: the map has 0 places and 100000 forbidden lines; up to 99990 can be written");
        assertThat(folder.resolve("full.pgm")).doesNotExist();
    }

    @Test
    void aPngIsReadLikeAPgm() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_GRAY);
        image.setRGB(0, 0, 0xFFFFFF);
        ImageIO.write(image, "png", folder.resolve("a.png").toFile());

        OccupancyGrid grid = read(YAML.replace("a.pgm", "a.png"), "").grid();

        assertThat(grid.state(0, 0)).isEqualTo(State.FREE);
        assertThat(grid.state(1, 0)).isEqualTo(State.OCCUPIED);
    }

    @Test
    void whatIsWrongIsSaidInOneSentence() {
        assertThatThrownBy(() -> read(YAML.replace("0.1", "wide"), PICTURE))
                .hasMessage("a.yaml, line 2: resolution has 'wide', but has to be a number from 0.001 to 100.0");
        assertThatThrownBy(() -> read("image: a.pgm\n", PICTURE))
                .hasMessage("a.yaml: resolution is missing, such as resolution: 0.05 (m a cell)");
        assertThatThrownBy(() -> read(YAML + "forbidden_lines:\n- {x1: 0, y1: 0, x2: 1}\n", PICTURE))
                .hasMessage("a.yaml, line 8: '- {x1: 0, y1: 0, x2: 1}' is no forbidden line;"
                        + " - {x1: 0, y1: 0, x2: 1.5, y2: 0.3} would be right (m)");
        assertThatThrownBy(() -> read(YAML + "forbidden_lines:\n- {x1: 0, y1: 9999999, x2: 1, y2: 1}\n", PICTURE))
                .hasMessageContaining("forbidden_lines has '9999999', but has to be a number from");
        assertThatThrownBy(() -> read(YAML, "P5 9 9 255\nshort"))
                .hasMessage("a.pgm: the picture ends in row 1; the whole file would be right");
        assertThatThrownBy(() -> read(YAML, "P5 100000 100000 255\n")).hasMessageContaining("100000 by 100000 pixels");
        assertThatThrownBy(() -> read(YAML, "GIF89a"))
                .hasMessage("a.pgm is no picture of a map: PGM (P5 or P2) or PNG would be right");
        assertThatThrownBy(() -> MapFiles.read(folder.resolve("a.txt")))
                .hasMessageContaining("a name that ends with .yaml (ROS) or .map (Pioneer) would be right");
    }

    @Test
    void aMapOfThePioneerWorldHasWallsPlacesHomeAndForbiddenLines() throws IOException {
        NavigationMap map = world("2D-Map\nMinPos: 0 0\nCairn: GoalWithHeading 500 400 90 \"\" ICON \"my desk\"\n"
                + "Cairn: Goal 100 200 0 \"\" ICON \"door\"\nCairn: RobotHome -182 176 10.5 \"\" ICON \"\"\n"
                + "Cairn: ForbiddenLine 0 0 0 \"\" ICON \"\" 1 2 3 4\n"
                + "Cairn: ForbiddenArea 0 0 90 \"\" ICON \"\" 100 0 200 50\nLINES\n0 0 1000 0\nDATA\n300 600\n");

        assertThat(map.places()).extracting(NavigationMap.Place::name).containsExactly("my desk", "door");
        assertThat(map.places().get(0).withHeading()).isTrue();
        assertThat(map.home()).contains(new Pose(-182, 176, 10.5));
        assertThat(map.forbidden()).hasSize(5).contains(new NavigationMap.ForbiddenLine(1, 2, 3, 4));
        assertThat(map.forbidden().get(1).fromYmm()).isCloseTo(100, within(0.001));
        assertThat(map.grid().stateAt(500, 20)).isEqualTo(State.OCCUPIED);
        assertThat(map.grid().stateAt(500, -20))
                .as("a wall is in the middle of cells")
                .isEqualTo(State.OCCUPIED);
        assertThat(map.grid().stateAt(310, 610)).isEqualTo(State.OCCUPIED);
        assertThat(map.grid().stateAt(500, 300)).isEqualTo(State.FREE);
    }

    @Test
    void aDamagedMapOfThePioneerWorldIsNamedWithItsLine() {
        assertThatThrownBy(() -> world("2D-Map\nLINES\n0 0 1000\n"))
                .hasMessage("w.map, line 3: '0 0 1000' is not 4 numbers in mm");
        assertThatThrownBy(() -> world("hello\n")).hasMessageContaining("begins with 2D-Map");
        assertThatThrownBy(() -> world("2D-Map\nLINES\n0 0 9000000 9000000\n")).hasMessageContaining("up to 400 m");
    }

    @Test
    void theMapsOfTheMakerAreRead() throws IOException {
        Path maps = Path.of("../shared/maps");
        assumeTrue(Files.exists(maps), "no maps of the maker at hand");

        NavigationMap office = MapFiles.read(maps.resolve("AMROffice.map"));
        NavigationMap columbia = MapFiles.read(maps.resolve("columbia.map"));

        assertThat(office.places()).extracting(NavigationMap.Place::name).contains("Far Away", "room4");
        assertThat(office.forbidden()).hasSize(7);
        assertThat(columbia.home()).isPresent();
    }
}
