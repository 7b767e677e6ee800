package majic.nav.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;

/**
 * Reads and writes files of maps. By the ending of the name: {@code .yaml} and {@code .yml} are those of ROS's
 * map_server with a picture (PGM P5 or P2, PNG), {@code .map} those of the Pioneer world. All methods block.
 *
 * <p>Limits: a map has at most {@value OccupancyGrid#MOST_CELLS} cells, such as 400 m by 400 m with cells of 50 mm.
 */
public final class MapFiles {
    private MapFiles() {}

    /**
     * Reads a map.
     *
     * @param file its ending names the format
     * @return the map
     * @throws IOException if it cannot be read, is damaged or too large: one sentence with file, line and what would be
     *     right
     */
    public static NavigationMap read(Path file) throws IOException {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return MapServerFile.read(file);
        }
        if (name.endsWith(".map")) {
            return PioneerWorldFile.read(file);
        }
        throw new IOException(NumberedLines.shortened(NumberedLines.name(file))
                + " is no map: a name that ends with .yaml (ROS) or .map (Pioneer) would be right");
    }

    /**
     * Writes a map for map_server: a YAML file and beside it a picture of the same name, each replaced as a whole.
     * Cells are written as free, occupied or unknown; places and forbidden lines stand under keys of their own, which
     * map_server passes over. Home is not written.
     *
     * @param yaml its name ends with {@code .yaml} or {@code .yml}
     * @param map what is written
     * @throws IOException if a file cannot be written, or the map has more than 99,990 places and forbidden lines
     */
    public static void write(Path yaml, NavigationMap map) throws IOException {
        MapServerFile.write(yaml, map);
    }
}
