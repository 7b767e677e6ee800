package majicsim.ros.bridge;

import java.util.HashMap;
import java.util.Map;
import majicsim.ros.graph.ActionServer;
import majicsim.ros.graph.GoalListener;

/** The goals of all clients by id: any client can cancel with the id that another one used (sheet 6). */
final class Goals {
    private final Map<String, Running> running = new HashMap<>();

    void add(String id, ActionServer server, GoalListener listener) {
        running.put(id, new Running(server, listener));
    }

    void remove(String id) {
        running.remove(id);
    }

    void cancel(String id) {
        Running goal = running.get(id);
        if (goal != null) {
            goal.server().cancel(goal.listener());
        }
    }

    private record Running(ActionServer server, GoalListener listener) {}
}
