package majic.ros.readings;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.LinkLost;
import majic.ros.bridge.ActionGoal;
import majic.ros.bridge.RosBridge;
import org.jspecify.annotations.Nullable;

/** One goal on a connection of its own. Thread-safe. */
final class BridgeGoal implements RosClient.GoalChannel {
    private static final Logger LOG = System.getLogger(BridgeGoal.class.getName());

    private final RosBridge own;
    private final RosBridge services;
    private volatile @Nullable String action;
    private volatile @Nullable String id;

    /**
     * Creates the channel of a goal.
     *
     * @param own closed with this channel
     * @param services over which a goal can be cancelled that blocks its own connection
     */
    BridgeGoal(RosBridge own, RosBridge services) {
        this.own = own;
        this.services = services;
    }

    @Override
    public void send(ActionGoal goal, ActionGoal.Events events) {
        action = goal.action();
        id = own.sendGoal(goal, events);
    }

    /**
     * The service is the only way that does not depend on the version; its empty request means all goals
     * (action_msgs/CancelGoal). It comes last: if it is not answered, it holds up what follows on its connection.
     */
    @Override
    public void cancel() {
        String known = action;
        if (known == null) {
            return;
        }
        String goal = id;
        if (goal != null) {
            attempt(() -> services.cancelGoal(known, goal));
            attempt(() -> own.cancelGoal(known, goal));
        }
        attempt(() -> services.request(known + "/_action/cancel_goal", JsonNodeFactory.instance.objectNode()));
    }

    private static void attempt(Runnable send) {
        try {
            send.run();
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "a goal could not be cancelled on one of the ways", e);
        }
    }

    @Override
    public void close() {
        own.close();
    }
}
