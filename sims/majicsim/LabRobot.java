package majicsim;

import java.util.List;
import majicsim.net.FirmwareClock;
import majicsim.net.Port;
import majicsim.net.Wiring;
import majicsim.world.Body;

/** One robot of the lab with its body and its ports; the second port, if there is one, is a pseudo-terminal. */
record LabRobot(String name, Body body, FirmwareClock clock, Wiring wiring, List<Port> ports) {

    void step(long labNanos) {
        clock.step(labNanos);
        for (Port port : ports) {
            port.step(labNanos);
        }
    }

    void close() {
        ports.forEach(Port::close);
    }
}
