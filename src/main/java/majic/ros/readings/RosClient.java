package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.ros.bridge.ActionGoal;
import majic.ros.bridge.ServiceFailed;
import majic.ros.bridge.TopicSubscription;

/** What readings, parameters and commands use of the connection with one robot. Thread-safe. */
public interface RosClient {
    /**
     * Returns which of the two systems the robot runs.
     *
     * @return true for ROS 2
     */
    boolean isRos2();

    /**
     * Returns whether the stamps of messages are of a simulated time, which need not pass at the rate of this
     * computer's.
     *
     * @return whether a simulator publishes the time
     */
    default boolean hasSimulatedTime() {
        return topics().containsKey("/clock");
    }

    /**
     * Returns the namespace of the robot.
     *
     * @return such as {@code /robot1}; empty for a robot without
     */
    String namespace();

    /**
     * Returns the topics that are known: those that were there while the robot was connected, or when they were listed
     * last.
     *
     * @return the types by the absolute names, unchangeable
     */
    Map<String, String> topics();

    /**
     * Lists the topics anew.
     *
     * @return the types by the absolute names, unchangeable
     * @throws BotException as {@link #call}
     */
    Map<String, String> listTopics();

    /**
     * Subscribes to a topic that is needed for motion or stop, on the connection that drives the robot.
     *
     * @param wanted the topic, its type, and how often
     * @param onMessage receives each message on the reader thread; must not wait
     * @return ends the subscription
     * @throws LinkLost if it could not be sent
     */
    Runnable subscribe(TopicSubscription wanted, Consumer<JsonNode> onMessage);

    /**
     * Returns the sensors that guards and maps read, such as scans.
     *
     * @return on a connection of their own
     */
    TopicSource sensors();

    /**
     * Returns what may be large: pictures, and topics whose size is not known.
     *
     * @return on a connection of their own
     */
    TopicSource large();

    /**
     * Asks the robot's node rosapi.
     *
     * @param question the last part of the name of the service, as {@code topics}
     * @param arguments by the names of their fields
     * @param timeoutS the longest wait, s
     * @return the values of the answer
     * @throws BotException as {@link #call}
     */
    JsonNode ask(String question, JsonNode arguments, double timeoutS);

    /**
     * Calls a service and waits for its answer.
     *
     * @param service its absolute name
     * @param arguments by the names of their fields
     * @param timeoutS the longest wait, s
     * @return the values of the answer
     * @throws ServiceFailed if the server reports a failure or does not answer
     * @throws BotException if the thread may not wait, or the connection is lost
     */
    JsonNode call(String service, JsonNode arguments, double timeoutS);

    /**
     * Calls a service and ignores the answer; waits for nothing.
     *
     * @param service its absolute name
     * @param arguments by the names of their fields
     * @throws LinkLost if it could not be sent
     */
    void request(String service, JsonNode arguments);

    /**
     * Publishes a message on a topic that is announced when it is used for the first time.
     *
     * @param topic its absolute name
     * @param type as rosapi names it
     * @param message an object with finite numbers
     * @throws LinkLost if it could not be sent
     */
    void publish(String topic, String type, JsonNode message);

    /**
     * Opens what a service is called over whose duration is not known: on ROS 2 a connection of its own, because
     * servers up to 2.1.0 handle nothing else on a connection until the service has answered.
     *
     * @param changed called when the service has answered, on the reader thread; must not wait
     * @return to be closed
     * @throws BotException if the server does not accept a further connection
     */
    CallChannel openCall(Runnable changed);

    /** What one service is called over. */
    interface CallChannel extends AutoCloseable {
        /**
         * Calls the service; called once, and waits for nothing.
         *
         * @param service its absolute name
         * @param arguments by the names of their fields
         * @throws LinkLost if it could not be sent
         */
        void send(String service, JsonNode arguments);

        /**
         * Returns whether the call is over.
         *
         * @return true once the service has answered or failed
         */
        boolean isDone();

        /**
         * Returns the answer.
         *
         * @return the values; empty if the call is not over
         * @throws BotException if the service failed, or the connection ended first
         */
        Optional<JsonNode> values();

        @Override
        void close();
    }

    /**
     * Opens what one goal of an action of ROS 2 is sent over. It is separate, because servers up to 2.1.0 handle
     * nothing else on a connection until the goal on it is finished, and never again if the goal is rejected (rosbridge
     * sheet 6).
     *
     * @return to be closed
     * @throws BotException if the server does not accept a further connection
     */
    GoalChannel openGoal();

    /** What one goal is sent over. */
    interface GoalChannel extends AutoCloseable {
        /**
         * Sends the goal; called once.
         *
         * @param goal the action and its arguments
         * @param events handles what becomes of it, on the reader thread
         * @throws LinkLost if it could not be sent
         */
        void send(ActionGoal goal, ActionGoal.Events events);

        /**
         * Cancels the goal on every way that some version of the server understands; waits for nothing. All goals of
         * the action are cancelled, those of other programs too: a robot that is to stop must not go on to any of them.
         */
        void cancel();

        @Override
        void close();
    }
}
