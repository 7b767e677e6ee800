package majicsim.ros;

import java.util.ArrayList;
import java.util.List;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.ros.bridge.BridgeFaults;
import majicsim.ros.bridge.BridgeServer;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.message.MessageTypes;
import majicsim.ros.message.RosVersion;
import majicsim.ros.options.RosOptions;
import majicsim.ros.robot.TurtleBot3;
import majicsim.ros.rosapi.Rosapi;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;

/**
 * A robot and its computer: the nodes of a TurtleBot3, rosapi and a rosbridge server; or several such robots behind one
 * server. Without a client it drives on until its command time-out, if it has one. Every method with the lab's lock
 * held.
 */
public final class RosRobot implements Firmware {
    /** The port at which a rosbridge server usually listens. */
    public static final int PORT = 9090;

    private static final double NANOS = 1e9;

    private final RosNetwork network;
    private final BridgeFaults bridgeFaults = new BridgeFaults();
    private final BridgeServer bridge;
    private final List<TurtleBot3> robots = new ArrayList<>();
    private final RosHandling handling;

    /**
     * A robot that has just been switched on.
     *
     * @param world the room; the robot adds its body
     * @param starts the start pose of each robot
     * @param noise of its wheels and sensors
     * @param options its kind
     * @throws IllegalArgumentException if it does not fit there
     */
    public RosRobot(World world, List<Pose> starts, Noise noise, RosOptions options) {
        network = new RosNetwork(MessageTypes.of(options.version()), options.serverNamespace());
        bridge = new BridgeServer(network, options, bridgeFaults);
        for (int i = 0; i < options.robots(); i++) {
            String name = i == 0 ? "ros" : "ros" + (i + 1);
            Body body = Body.disc(name, TurtleBot3.RADIUS_MM, starts.get(i));
            robots.add(new TurtleBot3(world, body, noise.fork(name), network, options, options.namespaceOf(i)));
        }
        handling = new RosHandling(network, bridge, bridgeFaults, robots);
        Rosapi.start(network, distribution(options));
        if (options.version() == RosVersion.ROS1) {
            network.parameters().put("/rosdistro", "\"" + distribution(options) + "\\n\"");
            network.parameters().put("/tb3_model", "\"burger\"");
        }
    }

    private static String distribution(RosOptions options) {
        if (options.version() == RosVersion.ROS1) {
            return "noetic";
        }
        return options.isStamped() ? "jazzy" : "humble";
    }

    /**
     * The body of the first robot.
     *
     * @return the body, named ros
     */
    public Body body() {
        return body(0);
    }

    /**
     * The body of one robot.
     *
     * @param number of the robot, from 0
     * @return the body, named ros, ros2 and so on
     */
    public Body body(int number) {
        return robots.get(number).body();
    }

    /**
     * What can be done to it.
     *
     * @return the same object at every call
     */
    public RosHandling handling() {
        return handling;
    }

    @Override
    public void connected(Line line) {
        bridge.connected(line);
    }

    @Override
    public void received(Line line, byte[] bytes) {
        bridge.received(line, bytes);
    }

    @Override
    public void disconnected(Line line) {
        bridge.disconnected(line);
    }

    @Override
    public void step(double seconds) {
        network.clock().advance(Math.round(seconds * NANOS));
        robots.forEach(robot -> robot.step(seconds));
        bridge.step();
    }

    @Override
    public long restNanos() {
        long rest = bridge.restNanos();
        for (TurtleBot3 robot : robots) {
            rest = Math.min(rest, robot.restNanos());
        }
        return rest;
    }
}
