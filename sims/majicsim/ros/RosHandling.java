package majicsim.ros;

import java.util.List;
import java.util.regex.Pattern;
import majicsim.ros.bridge.BridgeFaults;
import majicsim.ros.bridge.BridgeServer;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.robot.TurtleBot3;

/**
 * The faults of the robot and its computer, beside those of its line. Each lasts until it is ended. Every call must
 * hold the lab's lock.
 */
public final class RosHandling {
    private static final double NANOS = 1e9;
    private static final int SMALLEST_HUGE = 100;

    private final RosNetwork network;
    private final BridgeServer bridge;
    private final BridgeFaults faults;
    private final List<TurtleBot3> robots;

    RosHandling(RosNetwork network, BridgeServer bridge, BridgeFaults faults, List<TurtleBot3> robots) {
        this.network = network;
        this.bridge = bridge;
        this.faults = faults;
        this.robots = robots;
    }

    /**
     * Closes all connections with a close frame, as a bridge that is restarted.
     *
     * @param code of RFC 6455, as 1001
     * @param reason for the clients' logs, at most 100 characters
     */
    public void closeConnections(int code, String reason) {
        bridge.closeAll(code, reason);
    }

    /**
     * Makes the bridge hang: connections stay open, and nothing is answered, carried out or sent; or makes it go on
     * with what arrived meanwhile. Of a connection that was closed meanwhile only the first message is carried out. The
     * base is another process and goes on.
     *
     * @param hangs whether it hangs from now on
     */
    public void hang(boolean hangs) {
        bridge.hang(hangs);
    }

    /**
     * Leaves pings unanswered.
     *
     * @param without true from now on, false to end it
     */
    public void suppressPongs(boolean without) {
        faults.suppressPongs(without);
    }

    /**
     * Leaves calls of services unanswered.
     *
     * @param without true from now on, false to end it
     */
    public void suppressServices(boolean without) {
        faults.suppressServices(without);
    }

    /**
     * Cuts off the second half of the next messages to clients, so that they are no JSON.
     *
     * @param count how many
     */
    public void malform(int count) {
        faults.malform(count);
    }

    /**
     * Sends a message that nothing asked for to all clients.
     *
     * @param bytes its size, 100 or more
     * @throws IllegalArgumentException if it is less; nothing was sent
     */
    public void sendHuge(int bytes) {
        if (bytes < SMALLEST_HUGE) {
            throw new IllegalArgumentException("a huge message has 100 bytes or more, not " + bytes);
        }
        bridge.sendHuge(bytes);
    }

    /**
     * Hides topics from clients that ask, as if the robot did not have them.
     *
     * @param pattern regular expression of whole names; an empty one hides nothing
     */
    public void hideTopics(String pattern) {
        network.topics().hide(Pattern.compile(pattern).asMatchPredicate());
    }

    /**
     * Stops publishing a topic, as a sensor that has failed, or goes on.
     *
     * @param topic its name, as {@code /odom}
     * @param silent whether it is silent from now on
     * @throws IllegalArgumentException if the robot does not publish it
     */
    public void silence(String topic, boolean silent) {
        publisher(topic).silence(topic, silent);
    }

    /**
     * Publishes a topic at another rate.
     *
     * @param topic its name, as {@code /imu}
     * @param hertz above 0; 1000 floods
     * @throws IllegalArgumentException if the robot does not publish it, or for another rate
     */
    public void rate(String topic, double hertz) {
        if (!(hertz > 0)) {
            throw new IllegalArgumentException("a rate must be above 0 Hz, not " + hertz);
        }
        publisher(topic).rate(topic, hertz);
    }

    private TurtleBot3 publisher(String topic) {
        return robots.stream()
                .filter(robot -> robot.publishes(topic))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("the robot does not publish " + topic));
    }

    /**
     * Makes two of three readings of the laser unusable: NaN, both infinities and 0.
     *
     * @param spoilt whether it is so from now on
     */
    public void spoilScans(boolean spoilt) {
        robots.forEach(robot -> robot.spoilScans(spoilt));
    }

    /**
     * Sets the robot's clock forward or back.
     *
     * @param seconds by how much; negative is back
     */
    public void jumpClock(double seconds) {
        network.clock().jump(Math.round(seconds * NANOS));
    }

    /**
     * Rejects the goals of the navigation. On ROS 2 a rejected goal is never answered.
     *
     * @param rejects whether it is so from now on
     */
    public void rejectGoals(boolean rejects) {
        robots.forEach(robot -> robot.rejectGoals(rejects));
    }
}
