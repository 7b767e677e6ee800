package majic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import majicsim.LabOptions;
import majicsim.mavlink.MavlinkOptions;
import org.junit.jupiter.api.Test;

/** The lab as the program sees it. */
class SimulatedLabTest {
    @Test
    void theAddressOfAMavlinkVehicleIsAScheme() throws IOException {
        LabOptions options = LabOptions.exactOnFreePorts().withMavlink(MavlinkOptions.parse("rover,copter"));
        try (SimulatedLab lab = SimulatedLab.stepped(options)) {
            assertThat(lab.robots()).containsExactly("aibo", "pioneer", "hemisson", "mavlink", "mavlink2");
            assertThat(lab.address("mavlink2").orElseThrow())
                    .hasToString("mavlink://" + lab.simulators().addresses().get("mavlink2"));
        }
    }
}
