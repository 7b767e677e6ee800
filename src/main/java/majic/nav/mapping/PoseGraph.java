package majic.nav.mapping;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;
import majic.bot.Pose;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.DMatrixSparseCSC;
import org.ejml.data.DMatrixSparseTriplet;
import org.ejml.interfaces.linsol.LinearSolverSparse;
import org.ejml.ops.DConvertMatrixStruct;
import org.ejml.sparse.FillReducing;
import org.ejml.sparse.csc.CommonOps_DSCC;
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC;

/**
 * Poses and measured differences between them; finds the poses that fit the differences best: sparse least squares by
 * Gauss-Newton with a Cauchy kernel for the loops (Grisetti, Kümmerle, Stachniss, Burgard 2010; Konolige 2010). The
 * first pose is fixed. The kernel is wide at first and narrows to its width, so that a true loop pulls together what a
 * long way has moved apart, and a wrong one loses its weight afterwards (graduated non-convexity; Blake and Zisserman
 * 1987, Yang 2020). Not thread-safe.
 */
final class PoseGraph {
    /** Where the kernel halves the weight of a loop: the value that chi squared of three degrees exceeds once in 20. */
    private static final double KERNEL = 7.81;

    /** By which the kernel narrows from one iteration to the next. */
    private static final double NARROWING = 4;

    private static final double CONVERGED_MM = 1;

    /**
     * A measured difference.
     *
     * @param measured the pose {@code to}, seen from the pose {@code from}
     * @param information of it, in the frame of {@code from}
     * @param loop whether it may be wrong, and so gets less weight the less it fits
     * @param placeMm2 the variance of its place, mm², the mean of both directions
     * @param headingRad2 the variance of its heading
     */
    record Edge(
            int from,
            int to,
            Pose measured,
            Information information,
            boolean loop,
            double placeMm2,
            double headingRad2) {
        /** An edge from a covariance in the frame of {@code from}. */
        static Edge of(int from, int to, Pose measured, Information covariance, boolean loop) {
            return new Edge(
                    from,
                    to,
                    measured,
                    covariance.inverse(),
                    loop,
                    (covariance.xx() + covariance.yy()) / 2,
                    covariance.tt());
        }
    }

    private final List<Pose> poses = new ArrayList<>();
    private final List<Edge> edges = new ArrayList<>();

    /** The edges of each node. */
    private final List<List<Edge>> around = new ArrayList<>();

    int add(Pose pose) {
        poses.add(pose);
        around.add(new ArrayList<>());
        return poses.size() - 1;
    }

    void add(Edge edge) {
        edges.add(edge);
        around.get(edge.from()).add(edge);
        around.get(edge.to()).add(edge);
    }

    Pose pose(int node) {
        return poses.get(node);
    }

    int size() {
        return poses.size();
    }

    /** The squared Mahalanobis distance between a measured difference and that of the poses. */
    double misfit(Edge edge) {
        Pose error = error(edge);
        return edge.information().squared(error.xMm(), error.yMm(), Math.toRadians(error.headingDeg()));
    }

    /** The difference of the poses less the measured one, in the frame of {@code from}. */
    private Pose error(Edge edge) {
        Pose is = poses.get(edge.to()).seenFrom(poses.get(edge.from()));
        Pose wanted = edge.measured();
        return new Pose(is.xMm() - wanted.xMm(), is.yMm() - wanted.yMm(), is.headingDeg() - wanted.headingDeg());
    }

    /** Moves the poses to the best fit, in at most the given number of iterations. */
    void optimise(int iterations) {
        if (poses.size() < 2) {
            return;
        }
        EliminationOrder order = new EliminationOrder(poses.size() - 1);
        edges.stream().filter(edge -> edge.from() > 0).forEach(edge -> order.connect(edge.from() - 1, edge.to() - 1));
        int[] positions = order.positions();
        double kernel = edges.stream()
                .filter(Edge::loop)
                .mapToDouble(this::misfit)
                .max()
                .orElse(KERNEL);
        for (int iteration = 0; iteration < iterations; iteration++) {
            kernel = Math.max(KERNEL, kernel / NARROWING);
            if (step(positions, kernel) < CONVERGED_MM && kernel == KERNEL) {
                return;
            }
        }
    }

    /** Makes one iteration of Gauss-Newton and returns the largest displacement, mm. */
    private double step(int[] positions, double kernel) {
        int size = 3 * positions.length;
        DMatrixSparseTriplet triplets = new DMatrixSparseTriplet(size, size, 36 * edges.size());
        DMatrixRMaj right = new DMatrixRMaj(size, 1);
        double[][] first = new double[3][3];
        double[][] second = {{0, 0, 0}, {0, 0, 0}, {0, 0, 1}};
        for (Edge edge : edges) {
            Pose error = error(edge);
            double[] e = {error.xMm(), error.yMm(), Math.toRadians(error.headingDeg())};
            Information information = edge.information();
            if (edge.loop()) {
                information = information.times(1 / (1 + information.squared(e[0], e[1], e[2]) / kernel));
            }
            jacobians(edge, first, second);
            int i = edge.from() == 0 ? -1 : 3 * positions[edge.from() - 1];
            int j = 3 * positions[edge.to() - 1];
            double[][] wi = product(information, first);
            double[][] wj = product(information, second);
            addBlock(triplets, i, i, first, wi);
            addBlock(triplets, i, j, first, wj);
            addBlock(triplets, j, i, second, wi);
            addBlock(triplets, j, j, second, wj);
            double[] we = information.times(e[0], e[1], e[2]);
            addRight(right, i, first, we);
            addRight(right, j, second, we);
        }
        DMatrixSparseCSC matrix = DConvertMatrixStruct.convert(triplets, (DMatrixSparseCSC) null);
        CommonOps_DSCC.duplicatesAdd(matrix, null);
        LinearSolverSparse<DMatrixSparseCSC, DMatrixRMaj> solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE);
        DMatrixRMaj solution = new DMatrixRMaj(size, 1);
        if (!solver.setA(matrix)) {
            return 0;
        }
        solver.solve(right, solution);
        double largest = 0;
        for (int node = 1; node < poses.size(); node++) {
            int at = 3 * positions[node - 1];
            double dx = solution.get(at, 0);
            double dy = solution.get(at + 1, 0);
            Pose old = poses.get(node);
            poses.set(
                    node,
                    new Pose(
                            old.xMm() + dx,
                            old.yMm() + dy,
                            old.headingDeg() + Math.toDegrees(solution.get(at + 2, 0))));
            largest = Math.max(largest, Math.hypot(dx, dy));
        }
        return largest;
    }

    private void jacobians(Edge edge, double[][] first, double[][] second) {
        Pose from = poses.get(edge.from());
        Pose to = poses.get(edge.to());
        double angle = Math.toRadians(from.headingDeg());
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double dx = to.xMm() - from.xMm();
        double dy = to.yMm() - from.yMm();
        first[0] = new double[] {-c, -s, -s * dx + c * dy};
        first[1] = new double[] {s, -c, -c * dx - s * dy};
        first[2] = new double[] {0, 0, -1};
        second[0] = new double[] {c, s, 0};
        second[1] = new double[] {-s, c, 0};
    }

    private static double[][] product(Information information, double[][] jacobian) {
        double[][] result = new double[3][3];
        for (int column = 0; column < 3; column++) {
            double[] product = information.times(jacobian[0][column], jacobian[1][column], jacobian[2][column]);
            for (int row = 0; row < 3; row++) {
                result[row][column] = product[row];
            }
        }
        return result;
    }

    private static void addBlock(DMatrixSparseTriplet to, int row, int column, double[][] left, double[][] right) {
        if (row < 0 || column < 0 || row > column) {
            return;
        }
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                if (row + a <= column + b) {
                    double sum = left[0][a] * right[0][b] + left[1][a] * right[1][b] + left[2][a] * right[2][b];
                    to.addItem(row + a, column + b, sum);
                }
            }
        }
    }

    private static void addRight(DMatrixRMaj to, int row, double[][] jacobian, double[] error) {
        if (row < 0) {
            return;
        }
        for (int a = 0; a < 3; a++) {
            to.add(row + a, 0, -jacobian[0][a] * error[0] - jacobian[1][a] * error[1] - jacobian[2][a] * error[2]);
        }
    }

    /**
     * How uncertain the place of each node is, seen from another one.
     *
     * @param mm2 the variance of its place in each direction, mm²; infinite for a node that is not connected
     * @param rad2 the variance of its heading
     */
    record Variances(double[] mm2, double[] rad2) {}

    private record Reached(int node, double mm2, double rad2) {}

    /**
     * Adds up the variances along the best way through the edges (Dijkstra; the projection of Olson 2008, section 4.3).
     * An error of the heading at a node counts with its distance from the root.
     */
    Variances seenFrom(int root) {
        double[] mm2 = new double[poses.size()];
        double[] rad2 = new double[poses.size()];
        Arrays.fill(mm2, Double.POSITIVE_INFINITY);
        boolean[] done = new boolean[poses.size()];
        PriorityQueue<Reached> queue = new PriorityQueue<>((a, b) -> Double.compare(a.mm2(), b.mm2()));
        queue.add(new Reached(root, 0, 0));
        mm2[root] = 0;
        while (!queue.isEmpty()) {
            Reached next = queue.remove();
            if (done[next.node()]) {
                continue;
            }
            done[next.node()] = true;
            rad2[next.node()] = next.rad2();
            for (Edge edge : around.get(next.node())) {
                int other = edge.from() == next.node() ? edge.to() : edge.from();
                double lever = poses.get(other).distanceMm(poses.get(root));
                double cost = next.mm2() + edge.placeMm2() + edge.headingRad2() * lever * lever;
                if (!done[other] && cost < mm2[other]) {
                    mm2[other] = cost;
                    queue.add(new Reached(other, cost, next.rad2() + edge.headingRad2()));
                }
            }
        }
        return new Variances(mm2, rad2);
    }
}
