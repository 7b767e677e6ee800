package majicsim;

import java.util.List;
import majicsim.net.Port;
import majicsim.net.Wiring;
import majicsim.world.Body;

/** One robot of the lab with its body and its ports; the second port, if there is one, is a pseudo-terminal. */
record LabRobot(String name, Body body, Wiring wiring, List<Port> ports) {

    void step(double seconds, long labNanos) {
        wiring.firmware().step(seconds);
        ports.forEach(port -> port.step(labNanos));
    }

    void close() {
        ports.forEach(Port::close);
    }
}
