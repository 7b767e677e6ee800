package majic.nav.mapping;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Optional;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.mapping.ReferenceGrid.PlacedPoints;
import org.jspecify.annotations.Nullable;

/**
 * Odometry that is corrected by the last scans: each is matched to those of the last metres, without a map. Its frame
 * begins as that of the odometry. Memory is bounded by the {@value Mapper#RECENT} scans that are kept. Not thread-safe;
 * a scan of 180 echoes takes 3 ms.
 */
public final class ScanOdometry {
    private static final int LEVELS = 3;
    private static final double LEAST_SCORE = 0.2;

    private final Deque<PlacedPoints> recent = new ArrayDeque<>();
    private @Nullable Pose odometry;
    private Pose pose = Pose.START;

    /**
     * Adds a scan.
     *
     * @param scan its odometry in the same frame as that of the scans before
     * @return the corrected odometry
     */
    public Pose add(RangeScan scan) {
        EchoPoints points = EchoPoints.of(scan);
        if (odometry == null) {
            pose = scan.odometry();
            keep(points);
        } else {
            Pose moved = scan.odometry().seenFrom(odometry);
            SearchWindow window = SearchWindow.afterMotion(pose, moved);
            Information prior = Information.ofSigmas(window.sigmaMm(), window.sigmaDeg());
            ReferenceGrid reference = new ReferenceGrid(new ArrayList<>(recent), LEVELS);
            Optional<ScanMatch> match = ScanMatcher.match(reference, points, window, prior, LEAST_SCORE);
            pose = match.map(ScanMatch::pose).orElse(window.centre());
            PlacedPoints last = recent.getLast();
            if (last.pose().distanceMm(pose) >= Mapper.KEY_MM
                    || Math.abs(Pose.normalised(last.pose().headingDeg() - pose.headingDeg())) >= Mapper.KEY_DEG) {
                keep(points);
            }
        }
        odometry = scan.odometry();
        return pose;
    }

    private void keep(EchoPoints points) {
        recent.addLast(new PlacedPoints(points, pose));
        if (recent.size() > Mapper.RECENT) {
            recent.removeFirst();
        }
    }
}
