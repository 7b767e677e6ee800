package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import org.junit.jupiter.api.Test;

/** When the driver requests the laser of a simulator. */
class LaserRequestTest {
    private static final List<String> REQUEST =
            List.of("SIM_LRF_SET_FOV_START -90", "SIM_LRF_SET_FOV_END 90", "SIM_LRF_SET_RES 100", "SIM_LRF_ENABLE 1");
    private static final String END = "SIM_LRF_ENABLE 0";

    private final ScriptedPioneer robot = ScriptedPioneer.robot();
    private final List<RangeScan> scans = new CopyOnWriteArrayList<>();
    private final ScanListener listener = scan -> {
        if (scan.sensor().name().equals("laser")) {
            scans.add(scan);
        }
    };

    private List<String> laserOrders() {
        return robot.orders().stream()
                .filter(order -> order.startsWith("SIM_LRF"))
                .toList();
    }

    @Test
    void aSimulatorIsAskedOnceAtConnectingAndThenAtRest() {
        robot.hasLaser = true;
        try (PioneerRig rig = PioneerRig.connected(robot)) {
            assertThat(rig.bot.rangeSensors()).extracting(RangeSensor::name).containsExactly("sonar", "laser");
            rig.line.pass(3);

            assertThat(laserOrders())
                    .startsWith(REQUEST.toArray(String[]::new))
                    .hasSize(5)
                    .endsWith(END);
        }
    }

    @Test
    void scansComeWhileSomethingAsks() {
        robot.hasLaser = true;
        try (PioneerRig rig = PioneerRig.connected(robot)) {
            rig.line.pass(2);
            assertThat(scans).isEmpty();
            rig.bot.addScanListener(listener);
            rig.line.pass(2);

            assertThat(scans).hasSizeGreaterThan(10);
            assertThat(scans.get(0).rangeMm(0)).isEqualTo(900);
            assertThat(scans.get(0).rangeMm(2)).isEqualTo(Float.POSITIVE_INFINITY);

            rig.bot.removeScanListener(listener);
            rig.line.pass(1);
            assertThat(robot.heardLast(END)).isTrue();
        }
    }

    @Test
    void scansComeAgainAfterConnectingAgain() {
        robot.hasLaser = true;
        try (PioneerRig rig = PioneerRig.connected(robot)) {
            rig.bot.addScanListener(listener);
            rig.line.pass(1);
            rig.line.hangUp();
            rig.line.await(() -> !rig.bot.isConnected(), 5);
            int before = scans.size();
            rig.bot.connect();
            rig.line.pass(1);

            assertThat(scans).hasSizeGreaterThan(before + 5);
        }
    }

    @Test
    void aSimulatorWithoutALaserIsAskedAFewTimesOnly() {
        try (PioneerRig rig = PioneerRig.connected(robot)) {
            assertThat(rig.bot.rangeSensors()).extracting(RangeSensor::name).containsExactly("sonar");
            rig.bot.addScanListener(listener);
            rig.line.pass(20);

            assertThat(laserOrders()).hasSize(5 * REQUEST.size()).doesNotContain(END);
        }
    }

    @Test
    void aRealRobotIsNotAsked() {
        robot.serialNumber = "R42";
        try (PioneerRig rig = PioneerRig.connected(robot)) {
            rig.bot.addScanListener(listener);
            rig.line.pass(3);

            assertThat(laserOrders()).isEmpty();
        }
    }
}
