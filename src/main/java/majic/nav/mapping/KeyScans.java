package majic.nav.mapping;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.mapping.ReferenceGrid.PlacedPoints;

/** The scans that a map is made of, each a node of the graph of poses. Not thread-safe. */
final class KeyScans {
    private final PoseGraph graph = new PoseGraph();
    private final List<RangeScan> scans = new ArrayList<>();
    private final List<EchoPoints> points = new ArrayList<>();
    private long echoes;

    int size() {
        return scans.size();
    }

    long echoes() {
        return echoes;
    }

    RangeScan scan(int key) {
        return scans.get(key);
    }

    EchoPoints points(int key) {
        return points.get(key);
    }

    Pose pose(int key) {
        return graph.pose(key);
    }

    PoseGraph graph() {
        return graph;
    }

    int add(RangeScan scan, EchoPoints own, Pose pose) {
        scans.add(scan);
        points.add(own);
        echoes += own.count;
        return graph.add(pose);
    }

    /** Adds the difference between a scan and one that was matched to it or to its neighbours. */
    PoseGraph.Edge connect(int from, int to, ScanMatch match, boolean loop) {
        Pose origin = graph.pose(from);
        Information covariance = match.covariance().turned(-Math.toRadians(origin.headingDeg()));
        PoseGraph.Edge edge = PoseGraph.Edge.of(from, to, match.pose().seenFrom(origin), covariance, loop);
        graph.add(edge);
        return edge;
    }

    /** The scans from one key to another one at their places; the range is cut to those there are. */
    List<PlacedPoints> placed(int from, int to) {
        return IntStream.rangeClosed(Math.max(0, from), Math.min(to, size() - 1))
                .mapToObj(key -> new PlacedPoints(points.get(key), graph.pose(key)))
                .toList();
    }
}
