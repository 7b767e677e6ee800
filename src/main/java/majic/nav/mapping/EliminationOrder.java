package majic.nav.mapping;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Set;

/**
 * The order in which the nodes of a graph are eliminated so that a Cholesky factor stays sparse: always a node with the
 * fewest neighbours left (minimum degree; Tinney and Walker 1967).
 */
final class EliminationOrder {
    private record Entry(int node, int degree) {}

    private final List<Set<Integer>> neighbours = new ArrayList<>();

    EliminationOrder(int nodes) {
        for (int node = 0; node < nodes; node++) {
            neighbours.add(new HashSet<>());
        }
    }

    void connect(int one, int other) {
        if (one != other) {
            neighbours.get(one).add(other);
            neighbours.get(other).add(one);
        }
    }

    /** Returns the position of each node in the order; may be called once. */
    int[] positions() {
        int[] positions = new int[neighbours.size()];
        boolean[] done = new boolean[neighbours.size()];
        PriorityQueue<Entry> queue = new PriorityQueue<>((a, b) -> a.degree() != b.degree()
                ? Integer.compare(a.degree(), b.degree())
                : Integer.compare(a.node(), b.node()));
        for (int node = 0; node < positions.length; node++) {
            queue.add(new Entry(node, neighbours.get(node).size()));
        }
        for (int next = 0; next < positions.length; ) {
            Entry least = queue.remove();
            int node = least.node();
            if (done[node] || least.degree() != neighbours.get(node).size()) {
                continue;
            }
            done[node] = true;
            positions[node] = next++;
            Set<Integer> around = neighbours.get(node);
            for (int one : around) {
                Set<Integer> of = neighbours.get(one);
                of.addAll(around);
                of.remove(one);
                of.remove(node);
                queue.add(new Entry(one, of.size()));
            }
        }
        return positions;
    }
}
