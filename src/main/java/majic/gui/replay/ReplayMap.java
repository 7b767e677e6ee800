package majic.gui.replay;

import java.util.Comparator;
import java.util.List;
import majic.bot.RangeScan;
import majic.gui.map.MapPicture;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.NavigationMap;
import majic.recorder.RobotTracks;
import org.jspecify.annotations.Nullable;

/**
 * The map of what the laser scanners in a recording have measured up to a time, drawn where the robots were then. For
 * the thread of the player: an hour of driving takes seconds to draw.
 */
final class ReplayMap {
    /** The time between two drawings of the map, seconds of the recording. */
    private static final double DRAW_S = 1;

    private final List<Seen> all;
    private GridBuilder grid = new GridBuilder();
    private int drawn;
    private double drawnS = Double.NEGATIVE_INFINITY;
    private @Nullable MapPicture picture;

    /** A scan of a robot. */
    private record Seen(RobotTracks tracks, RangeScan scan) {}

    ReplayMap(List<RobotTracks> robots) {
        all = robots.stream()
                .flatMap(tracks -> tracks.scans().stream().map(scan -> new Seen(tracks, scan)))
                .sorted(Comparator.comparingDouble(seen -> seen.scan.timeS()))
                .toList();
    }

    /** Returns the map at a time; null if nothing was measured so far. */
    @Nullable
    MapPicture at(double seconds) {
        if (seconds < drawnS) {
            grid = new GridBuilder();
            drawn = 0;
            picture = null;
        } else if (seconds < drawnS + DRAW_S) {
            return picture;
        }
        int before = drawn;
        for (; drawn < all.size() && all.get(drawn).scan.timeS() <= seconds; drawn++) {
            Seen seen = all.get(drawn);
            double then = seen.scan.timeS();
            grid.add(seen.scan, seen.tracks.origin(then).plus(seen.tracks.pose(then)));
        }
        drawnS = seconds;
        if (drawn > before) {
            picture = new MapPicture(NavigationMap.of(grid.toGrid()));
        }
        return picture;
    }
}
