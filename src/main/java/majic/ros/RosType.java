package majic.ros;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.ros.bridge.BridgeAddress;
import majic.ros.panel.RosReplay;

/** Robots that speak ROS among the types of robots. */
public final class RosType implements BotType {
    /** Used by the service loader. */
    public RosType() {}

    @Override
    public String name() {
        return RosAddress.SCHEME;
    }

    @Override
    public List<String> otherSchemes() {
        return List.of(RosAddress.SECURE_SCHEME);
    }

    @Override
    public boolean isOneOfSeveral() {
        return true;
    }

    @Override
    public String label() {
        return "ROS robot";
    }

    @Override
    public String make() {
        return "ROS robot";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP);
    }

    @Override
    public int defaultPort(String scheme) {
        return BridgeAddress.PORT;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return new MajicRos(address, environment);
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new RosReplay(recorded);
    }

    @Override
    public String advice() {
        return "Is the robot on, and does its rosbridge server run (roslaunch rosbridge_server rosbridge_websocket.launch, or"
                + " ros2 launch rosbridge_server rosbridge_websocket_launch.xml)? Its port is usually 9090.";
    }
}
