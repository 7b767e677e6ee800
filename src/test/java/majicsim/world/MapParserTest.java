package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MapParserTest {
    @Test
    void readsWallsHomesAndBoxesAndSkipsUnknownLines() throws IOException {
        Room room = parse("""
                2D-Map
                MapInfo: GoalType "Name=Goal"
                Cairn: RobotHome 10 20 90.0 "" ICON "start"
                NumLines: 2
                Cairn: ForbiddenLine 0 0 0 "" ICON "" 1 2 3 4
                Cairn: Sim.BoxObstacle 0 0 0 "" ICON "a box" 100 200 300 400
                LINES
                -1000 0 1000 0
                -1000 50 1000.5 50
                DATA
                7 7
                """);
        assertThat(room.homes()).containsExactly(new Pose(10, 20, 90));
        assertThat(room.walls()).hasSize(6).contains(new Segment(-1000, 50, 1000.5, 50, 1));
        assertThat(room.bounds()).isEqualTo(new Bounds(-1000, 0, 1000.5, 400));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "2D-Mop; | m.map:1: a map begins with the line 2D-Map, not with '2D-Mop'",
                "2D-Map; | m.map:2: the map ends without its LINES",
                "2D-Map;NumLines: many; | m.map:2: NumLines must be a whole number, not 'many'",
                "2D-Map;NumLines: 2;LINES;1 2 3 4; | m.map:5: NumLines promises 2 lines, but 1 follow LINES",
                "2D-Map;LINES;1 2 3; | m.map:3: a line needs four numbers x1 y1 x2 y2, not '1 2 3'",
                "2D-Map;LINES;1 2 3 four; | m.map:3: y2 must be a number, not 'four'",
                "2D-Map;LINES;1 2 3 4e9; | m.map:3: y2 must lie within 1 km of the origin, not '4e9'",
                "2D-Map;LINES;1 NaN 3 4; | m.map:3: y1 must lie within 1 km of the origin, not 'NaN'",
                "2D-Map;Cairn: RobotHome 3 4;LINES; | m.map:2: heading is missing",
                "'' | m.map:1: a map begins with the line 2D-Map, not with an empty file",
            })
    void namesTheFileTheLineAndTheMistake(String text, String message) {
        assertThatThrownBy(() -> parse(text.replace(';', '\n')))
                .isInstanceOf(IOException.class)
                .hasMessage(message);
    }

    @Test
    void aFileThatIsNotThereIsNamed(@TempDir Path folder) {
        Path missing = folder.resolve("none.map");
        assertThatThrownBy(() -> Room.load(missing)).hasMessage("there is no map file " + missing);
        assertThatThrownBy(() -> Room.load(folder)).hasMessage(folder + " is a folder, not a map file");
    }

    private static Room parse(String text) throws IOException {
        return Room.parse(new StringReader(text), "m.map");
    }
}
