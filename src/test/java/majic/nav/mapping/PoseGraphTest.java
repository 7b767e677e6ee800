package majic.nav.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class PoseGraphTest {
    private static final Information COVARIANCE = Information.ofSigmas(20, 0.5).inverse();

    /** A square of 40 poses that are measured a little too far turned. */
    private static PoseGraph square() {
        PoseGraph graph = new PoseGraph();
        Pose pose = Pose.START;
        graph.add(pose);
        for (int node = 1; node <= 40; node++) {
            Pose step = new Pose(1000, 0, node % 10 == 0 ? 91 : 0);
            pose = pose.plus(step);
            graph.add(pose);
            graph.add(PoseGraph.Edge.of(node - 1, node, step, COVARIANCE, false));
        }
        return graph;
    }

    @Test
    void aLoopBringsTheEndsTogether() {
        PoseGraph graph = square();
        graph.add(PoseGraph.Edge.of(
                0, 40, Pose.START, Information.ofSigmas(5, 0.1).inverse(), true));

        graph.optimise(30);

        assertThat(graph.pose(40).distanceMm(Pose.START)).isLessThan(20);
        assertThat(graph.pose(20).distanceMm(new Pose(10_000, 10_000, 180))).isLessThan(150);
    }

    @Test
    void aWrongLoopAmongTrueOnesLosesItsWeight() {
        PoseGraph graph = square();
        for (int node = 0; node < 3; node++) {
            Pose measured = Pose.START.seenFrom(new Pose(1000 * node, 0, 0));
            graph.add(PoseGraph.Edge.of(node, 40, measured, COVARIANCE, true));
        }
        graph.add(PoseGraph.Edge.of(5, 25, new Pose(100, 0, 0), COVARIANCE, true));

        graph.optimise(30);

        assertThat(graph.pose(40).distanceMm(Pose.START)).isLessThan(50);
        assertThat(graph.pose(25).distanceMm(new Pose(5000, 10_000, 180))).isLessThan(300);
    }

    @Test
    void uncertaintyGrowsAlongTheWayAndShrinksThroughALoop() {
        PoseGraph graph = square();
        double before = graph.seenFrom(40).mm2()[0];
        graph.add(PoseGraph.Edge.of(0, 40, Pose.START, COVARIANCE, true));

        assertThat(graph.seenFrom(40).mm2()[30]).isPositive();
        assertThat(before).isGreaterThan(graph.seenFrom(40).mm2()[30]);
        assertThat(graph.seenFrom(40).mm2()[0]).isCloseTo(400, within(50.0));
    }

    @Test
    void theOrderOfEliminationHasEachNodeOnceAndBeginsWithFewNeighbours() {
        EliminationOrder order = new EliminationOrder(5);
        for (int node = 1; node < 5; node++) {
            order.connect(0, node);
        }

        int[] positions = order.positions();

        assertThat(positions).containsExactlyInAnyOrder(0, 1, 2, 3, 4);
        assertThat(positions[0]).isGreaterThanOrEqualTo(3);
    }
}
