package majic.nav.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid;

/**
 * The shortest way across a space: A* over the cells of the map (Hart, Nilsson, Raphael 1968), then the straight lines
 * that cost no more. A way close to an obstacle costs up to twice its length, so that it keeps away where there is
 * room. What is unknown is not crossed, and a fence is not left: it is round, so no straight line between two places
 * inside leaves it. Used by one thread.
 */
public final class PathPlanner {
    /** Ways keep as far from obstacles where there is room, mm. */
    private static final double COMFORT_MM = 250;

    /** Nodes are about as far apart, mm; a whole number of cells. */
    private static final double NODE_MM = 100;

    private static final int[] RIGHT = {1, 1, 0, -1, -1, -1, 0, 1};
    private static final int[] UP = {0, 1, 1, 1, 0, -1, -1, -1};

    /** The same among other robots, so that two of them pass each other in a corridor, each on its right. */
    private static final double COMFORT_IN_TRAFFIC_MM = 150;

    /** What driving elsewhere than on the right costs more, as a share, where a wall is as near. */
    private static final double ON_THE_LEFT = 0.4;

    private static final double LANE_MM = 1500;

    private static final double LANE_WIDTH_MM = 100;

    /** The sine of the angle from which on a wall is on the right. */
    private static final double ON_THE_RIGHT = 0.5;

    private final FreeSpace space;
    private final boolean traffic;
    private final double comfortMm;
    private final OccupancyGrid grid;
    private final BitSet blocked = new BitSet();
    private PlanNodes nodes;

    /**
     * A planner for one robot alone.
     *
     * @param space where the robot fits
     */
    public PathPlanner(FreeSpace space) {
        this(space, false);
    }

    /**
     * A planner for one space.
     *
     * @param space where the robot fits
     * @param traffic whether other robots are under way, so that it keeps to the right
     */
    public PathPlanner(FreeSpace space, boolean traffic) {
        this.space = space;
        this.traffic = traffic;
        this.comfortMm = traffic ? COMFORT_IN_TRAFFIC_MM : COMFORT_MM;
        this.grid = space.map().grid();
        this.nodes = nodes(cellsOfNode());
    }

    private int cellsOfNode() {
        return (int) Math.max(1, Math.round(NODE_MM / grid.cellMm()));
    }

    private PlanNodes nodes(int cells) {
        return space.map().nodes(cells, space.bodyMm(), comfortMm);
    }

    /**
     * Plans the shortest way to one of several places.
     *
     * @param from where the robot is
     * @param mostMm the longest way
     * @param isGood whether the robot may end at a place
     * @return to the nearest such place; empty if there is none
     */
    public Optional<Way> planToNearest(Pose from, double mostMm, Predicate<Pose> isGood) {
        setNodes(cellsOfNode());
        int start = node(from);
        if (start < 0) {
            return Optional.empty();
        }
        try (Search search = new Search(start, from, -1)) {
            int end = search.run((node, cost) -> cost > 0 && isGood.test(place(node)), mostMm);
            return end < 0 ? Optional.empty() : Optional.of(straightened(search.corners(end, place(end))));
        }
    }

    /**
     * Plans a way.
     *
     * @param from where the robot is, also closer to an obstacle than elsewhere, or where nothing is known
     * @param to where it should be
     * @return from the one to the other; empty if there is none
     */
    public Optional<Way> plan(Pose from, Pose to) {
        int coarse = cellsOfNode();
        Optional<Way> found = plan(from, to, coarse);
        return found.isPresent() || coarse == 1 ? found : plan(from, to, 1);
    }

    private Optional<Way> plan(Pose from, Pose to, int cellsOfNode) {
        setNodes(cellsOfNode);
        int start = node(from);
        int goal = node(to);
        if (start < 0 || goal < 0) {
            return Optional.empty();
        }
        int around = 1 + (int) Math.ceil((space.bodyMm() + 2 * FreeSpace.MARGIN_MM) / nodeMm());
        if (!nodes.mayReach(start, around, goal)) {
            return Optional.empty();
        }
        try (Search search = new Search(start, from, goal)) {
            int end = search.run((node, cost) -> node == goal, Double.POSITIVE_INFINITY);
            return end < 0 ? Optional.empty() : Optional.of(straightened(search.corners(end, to)));
        }
    }

    private void setNodes(int cellsOfNode) {
        if (nodes.cells != cellsOfNode) {
            nodes = nodes(cellsOfNode);
        }
        stamp();
    }

    private int node(Pose place) {
        Pose seen = place.seenFrom(grid.origin());
        int column = (int) Math.floor(seen.xMm() / nodeMm());
        int row = (int) Math.floor(seen.yMm() / nodeMm());
        return column < 0 || row < 0 || column >= nodes.columns || row >= nodes.rows ? -1 : nodes.node(column, row);
    }

    private double nodeMm() {
        return nodes.cells * grid.cellMm();
    }

    private Pose place(int node) {
        return grid.centre(
                nodes.middle(nodes.column(node), grid.width()), nodes.middle(nodes.row(node), grid.height()));
    }

    /** Blocks the nodes that are too close to something that is not on the map. */
    private void stamp() {
        blocked.clear();
        double nodeMm = nodeMm();
        for (FreeSpace.Disc thing : space.things()) {
            double reach = thing.radiusMm() + space.bodyMm() + FreeSpace.MARGIN_MM;
            Pose seen = new Pose(thing.xMm(), thing.yMm(), 0).seenFrom(grid.origin());
            int low = (int) Math.max(0, Math.floor((seen.yMm() - reach) / nodeMm));
            int high = (int) Math.min(nodes.rows - 1, Math.floor((seen.yMm() + reach) / nodeMm));
            int left = (int) Math.max(0, Math.floor((seen.xMm() - reach) / nodeMm));
            int right = (int) Math.min(nodes.columns - 1, Math.floor((seen.xMm() + reach) / nodeMm));
            for (int row = low; row <= high; row++) {
                for (int column = left; column <= right; column++) {
                    int node = nodes.node(column, row);
                    Pose there = place(node);
                    if (thing.distanceMm(there.xMm(), there.yMm()) < reach - thing.radiusMm()) {
                        blocked.set(node);
                    }
                }
            }
        }
    }

    /**
     * Nodes in the order of their estimated whole way, in a ring of stacks for ranges of it. An edge makes the estimate
     * longer by at most five times the distance of two nodes, so that the ring never overtakes itself.
     */
    private static final class Frontier {
        private static final int STACKS = 128;
        private static final int STACKS_OF_NODE = 16;

        private final int[][] stacks = new int[STACKS][64];
        private final int[] sizes = new int[STACKS];
        private final double rangeMm;
        private int count;
        private int current;

        Frontier(double nodeMm) {
            rangeMm = nodeMm / STACKS_OF_NODE;
        }

        void add(int node, float estimate) {
            int stack = (int) (estimate / rangeMm) % STACKS;
            if (sizes[stack] == stacks[stack].length) {
                stacks[stack] = Arrays.copyOf(stacks[stack], 2 * sizes[stack]);
            }
            stacks[stack][sizes[stack]++] = node;
            count++;
        }

        void beginAt(float estimate) {
            current = (int) (estimate / rangeMm) % STACKS;
        }

        /** Returns the next node; -1 if there is none. */
        int next() {
            if (count == 0) {
                return -1;
            }
            while (sizes[current] == 0) {
                current = (current + 1) % STACKS;
            }
            count--;
            return stacks[current][--sizes[current]];
        }
    }

    /** What a search looks for. */
    private interface Sought {
        boolean isAt(int node, float costMm);
    }

    /** One search from a node: what the way to each node costs, and from where it came. */
    private final class Search implements AutoCloseable {
        private static final byte DONE = 8;
        private static final byte DIRECTION = 7;

        private final int start;
        private final Pose from;

        /** The node that is looked for, which the robot may reach in any case; -1 if it is not known. */
        private final int goal;

        private final int goalColumn;
        private final int goalRow;
        private final PlanNodes.Workspace arrays = nodes.take();
        private final float[] cost = arrays.cost;

        /** The direction in which the node is reached, and whether it is done. */
        private final byte[] came = arrays.came;

        private final int[] steps = new int[RIGHT.length];
        private final float[] lengths = new float[RIGHT.length];
        private final float nodeMm = (float) nodeMm();
        private final boolean hasThings = !blocked.isEmpty();
        private final Frontier frontier = new Frontier(nodeMm);

        /** Robots that stand too close to something may leave it, but not come closer. */
        private final double leastMm;

        Search(int start, Pose from, int goal) {
            this.start = start;
            this.from = from;
            this.goal = goal;
            this.goalColumn = nodes.column(goal);
            this.goalRow = nodes.row(goal);
            this.leastMm = Math.min(0, space.mm(from.xMm(), from.yMm())) - nodeMm;
            Arrays.fill(cost, Float.POSITIVE_INFINITY);
            Arrays.fill(came, (byte) 0);
            for (int direction = 0; direction < RIGHT.length; direction++) {
                steps[direction] = UP[direction] * nodes.stride + RIGHT[direction];
                lengths[direction] = (float) (nodeMm * (direction % 2 == 0 ? 1 : Math.sqrt(2)));
            }
        }

        @Override
        public void close() {
            nodes.giveBack(arrays);
        }

        /** Returns the node that was looked for; -1 if there is none. */
        int run(Sought sought, double mostMm) {
            cost[start] = 0;
            float whole = estimate(nodes.column(start), nodes.row(start));
            frontier.beginAt(whole);
            frontier.add(start, whole);
            for (int node = frontier.next(); node >= 0; node = frontier.next()) {
                if (sought.isAt(node, cost[node])) {
                    return node;
                }
                if ((came[node] & DONE) == 0 && cost[node] <= mostMm) {
                    came[node] |= DONE;
                    expand(node);
                }
            }
            return -1;
        }

        private void expand(int node) {
            int column = nodes.column(node);
            int row = nodes.row(node);
            float before = cost[node];
            for (int direction = 0; direction < steps.length; direction++) {
                int next = node + steps[direction];
                // No price is below 1.
                if (cost[next] <= before + lengths[direction] || (came[next] & DONE) != 0) {
                    continue;
                }
                float price = price(next, column + RIGHT[direction], row + UP[direction], direction);
                float total = before + lengths[direction] * price;
                if (total < cost[next]) {
                    cost[next] = total;
                    came[next] = (byte) direction;
                    frontier.add(next, total + estimate(column + RIGHT[direction], row + UP[direction]));
                }
            }
        }

        /** What a millimetre costs at a node: 1 where there is room, infinite where the robot does not fit. */
        private float price(int node, int column, int row, int direction) {
            byte code = nodes.code(node);
            if (code == PlanNodes.BORDER) {
                return Float.POSITIVE_INFINITY;
            }
            if (code == PlanNodes.CLOSED || hasThings && blocked.get(node) || isOutOfFence(node)) {
                return node == goal || isAround(node) ? 2 : Float.POSITIVE_INFINITY;
            }
            return traffic
                    ? PlanNodes.price(code) + onTheLeftOfNode(column, row, RIGHT[direction], UP[direction])
                    : PlanNodes.price(code);
        }

        private boolean isOutOfFence(int node) {
            if (space.fence() == null) {
                return false;
            }
            Pose there = place(node);
            return !space.isInFence(there.xMm(), there.yMm());
        }

        /** The shortest way to the goal in steps from node to node. */
        private float estimate(int column, int row) {
            return goal < 0 ? 0 : nodeMm * (float) octile(column - goalColumn, row - goalRow);
        }

        private boolean isAround(int node) {
            double nearMm = space.bodyMm() + 2 * FreeSpace.MARGIN_MM;
            int right = nodes.column(node) - nodes.column(start);
            int up = nodes.row(node) - nodes.row(start);
            if (nodeMm * octile(right, up) > 2 * nearMm) {
                return false;
            }
            Pose there = place(node);
            return from.distanceMm(there) <= nearMm && space.mm(there.xMm(), there.yMm()) >= leastMm;
        }

        List<Pose> corners(int end, Pose to) {
            List<Pose> corners = new ArrayList<>();
            corners.add(to);
            for (int node = end; node != start; ) {
                node -= steps[came[node] & DIRECTION];
                corners.add(node == start ? from : place(node));
            }
            if (end == start) {
                corners.add(from);
            }
            Collections.reverse(corners);
            return corners;
        }
    }

    private static double octile(int right, int up) {
        int most = Math.max(Math.abs(right), Math.abs(up));
        return most + (Math.sqrt(2) - 1) * Math.min(Math.abs(right), Math.abs(up));
    }

    private float onTheLeftOfNode(int column, int row, int right, int up) {
        return (float) onTheLeft(nodes.middle(column, grid.width()), nodes.middle(row, grid.height()), right, up);
    }

    /** What a cell costs more in traffic unless the nearest wall is on the right of a robot that drives there. */
    private double onTheLeft(int x, int y, double right, double up) {
        if (!traffic || x == 0 || y == 0 || x == grid.width() - 1 || y == grid.height() - 1) {
            return 0;
        }
        ObstacleDistance map = space.map();
        if (map.mmOfCell(x, y) > LANE_MM) {
            return 0;
        }
        double awayX = map.mmOfCell(x + 1, y) - map.mmOfCell(x - 1, y);
        double awayY = map.mmOfCell(x, y + 1) - map.mmOfCell(x, y - 1);
        double length = Math.sqrt((awayX * awayX + awayY * awayY) * (right * right + up * up));
        double leftward = length == 0 ? 0 : (right * awayY - up * awayX) / length;
        if (leftward < ON_THE_RIGHT) {
            return ON_THE_LEFT;
        }
        double beside = map.mmOfCell(x, y) - space.bodyMm() - comfortMm - LANE_WIDTH_MM;
        return ON_THE_LEFT * Math.max(0, Math.min(1, beside / (2 * LANE_WIDTH_MM)));
    }

    /** Leaves out corners where the straight line costs no more. */
    private Way straightened(List<Pose> corners) {
        double[] cost = new double[corners.size()];
        for (int index = 1; index < cost.length; index++) {
            cost[index] =
                    cost[index - 1] + costOfLine(corners.get(index - 1), corners.get(index), Double.POSITIVE_INFINITY);
        }
        List<Pose> kept = new ArrayList<>();
        kept.add(corners.get(0));
        int at = 0;
        while (at < corners.size() - 1) {
            int next = at + 1;
            for (int step = 2; at + step < corners.size(); step += 1 + step / 4) {
                int far = at + step;
                if (isAsCheap(corners.get(at), corners.get(far), cost[far] - cost[at])) {
                    next = far;
                }
            }
            int end = corners.size() - 1;
            if (next != end && isAsCheap(corners.get(at), corners.get(end), cost[end] - cost[at])) {
                next = end;
            }
            kept.add(corners.get(next));
            at = next;
        }
        return Way.through(kept);
    }

    private boolean isAsCheap(Pose from, Pose to, double cost) {
        return from.distanceMm(to) <= cost + 1 && costOfLine(from, to, cost + 1) <= cost + 1;
    }

    private double onTheLeft(double xMm, double yMm, Pose direction) {
        if (!traffic) {
            return 0;
        }
        Pose seen = new Pose(xMm, yMm, 0).seenFrom(grid.origin());
        int x = (int) Math.floor(seen.xMm() / grid.cellMm());
        int y = (int) Math.floor(seen.yMm() / grid.cellMm());
        boolean inside = x >= 0 && y >= 0 && x < grid.width() && y < grid.height();
        return inside ? onTheLeft(x, y, direction.xMm(), direction.yMm()) : 0;
    }

    /**
     * Returns what a straight piece costs; a part of it where the robot does not fit costs a hundredfold.
     *
     * @param most a higher cost is not computed to its end
     */
    private double costOfLine(Pose from, Pose to, double most) {
        double length = from.distanceMm(to);
        int steps = (int) Math.ceil(2 * length / grid.cellMm());
        double sum = 0;
        Pose direction = new Pose(to.xMm() - from.xMm(), to.yMm() - from.yMm(), 0)
                .seenFrom(new Pose(0, 0, grid.origin().headingDeg()));
        for (int step = 1; step <= steps && sum * length <= most * steps; step++) {
            double share = (double) step / steps;
            double x = from.xMm() + share * (to.xMm() - from.xMm());
            double y = from.yMm() + share * (to.yMm() - from.yMm());
            double price =
                    space.map().isKnown(x, y) ? PlanNodes.price(space.mm(x, y), comfortMm) : Double.POSITIVE_INFINITY;
            sum += price == Double.POSITIVE_INFINITY ? 100 : price + onTheLeft(x, y, direction);
        }
        return steps == 0 ? 0 : sum * length / steps;
    }
}
