package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import majic.bot.LinkLost;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.TopicSubscription;

/**
 * Topics that are not needed for motion and stop, on a connection of their own: a large message on it delays neither
 * the odometry nor a stop. Its loss does not end the connection with the robot. Thread-safe.
 */
public interface TopicSource {
    /**
     * Subscribes to a topic; again after each loss of the connection. Waits for nothing.
     *
     * @param wanted the topic, its type, and how often
     * @param receiver handles what arrives
     * @return ends the subscription
     * @throws LinkLost if the connection with the robot has ended
     */
    Runnable subscribe(TopicSubscription wanted, Receiver receiver);

    /**
     * Returns what is arriving on the connection.
     *
     * @return nothing if the connection is not open
     */
    Arriving arriving();

    /**
     * Returns how long a message takes to the server and back on the connection.
     *
     * @return seconds; 0 if that is not known
     */
    double roundTripS();

    /** Handles what arrives. Called on the reader thread, which must not wait. */
    interface Receiver {
        /**
         * Handles a message.
         *
         * @param message its content
         * @param bytes its length on the connection
         */
        void message(JsonNode message, int bytes);

        /** Handles the loss of the connection: what has arrived is no reading any more. */
        void lost();
    }
}
