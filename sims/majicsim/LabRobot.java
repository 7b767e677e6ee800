package majicsim;

import java.util.List;
import majicsim.net.Port;
import majicsim.net.Wiring;
import majicsim.world.Body;

/**
 * One robot of the lab with its body and its ports; beside a TCP port it may have a pseudo-terminal or a port for
 * datagrams. Several ROS robots share the firmware and the port of the first one, which closes them for all; the path
 * behind the address tells them apart.
 */
record LabRobot(String name, Body body, Wiring wiring, List<Port> ports, String path, boolean isSharing) {

    static LabRobot alone(String name, Body body, Wiring wiring, List<Port> ports) {
        return new LabRobot(name, body, wiring, ports, "", false);
    }

    /** The same robot, behind a path of its address. */
    LabRobot at(String newPath) {
        return new LabRobot(name, body, wiring, ports, newPath, isSharing);
    }

    /** A further robot behind the same port. */
    LabRobot sharing(String newName, Body newBody, String newPath) {
        return new LabRobot(newName, newBody, wiring, ports, newPath, true);
    }

    /** The ports that are its own. */
    List<Port> ownPorts() {
        return isSharing ? List.of() : ports;
    }

    void close() {
        ownPorts().forEach(Port::close);
    }
}
