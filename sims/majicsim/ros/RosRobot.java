package majicsim.ros;

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
 * A robot and its computer: the nodes of a TurtleBot3, rosapi and a rosbridge server. Without a client it drives on until its
 * command time-out, if it has one. Every method with the lab's lock held.
 */
public final class RosRobot implements Firmware {
    /** The port at which a rosbridge server usually listens. */
    public static final int PORT = 9090;

    private static final double NANOS = 1e9;

    private final RosNetwork network;
    private final BridgeFaults bridgeFaults = new BridgeFaults();
    private final BridgeServer bridge;
    private final TurtleBot3 robot;
    private final RosHandling handling;

    /**
     * A robot that has just been switched on.
     *
     * @param world the room; the robot adds its body
     * @param start its start pose
     * @param noise of its wheels and sensors
     * @param options its kind
     * @throws IllegalArgumentException if it does not fit there
     */
    public RosRobot(World world, Pose start, Noise noise, RosOptions options) {
        network = new RosNetwork(MessageTypes.of(options.version()));
        bridge = new BridgeServer(network, options, bridgeFaults);
        Body body = Body.disc("ros", TurtleBot3.RADIUS_MM, start);
        robot = new TurtleBot3(world, body, noise, network, options);
        handling = new RosHandling(network, bridge, bridgeFaults, robot);
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
     * Its body in the world.
     *
     * @return the body, named ros
     */
    public Body body() {
        return robot.body();
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
        robot.step(seconds);
        bridge.step();
    }

    @Override
    public long restNanos() {
        return Math.min(robot.restNanos(), bridge.restNanos());
    }
}
