import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.nav.Destination;
import majic.nav.Navigator;
import org.junit.jupiter.api.Test;

/** Tests the driver of the cart: what every driver has to do, and what is particular to a cart. */
class CartTest extends DriverConformance {
    private CartPeer cart;

    @Override
    protected TestedRobot newRobot() {
        cart = new CartPeer();
        return cart;
    }

    @Test
    void aCartThatSendsNoReportsCountsAsLost() {
        cart.bot().connect();

        cart.fallSilent();

        assertThrows(LinkLost.class, () -> cart.bot().move(300));
        assertEquals("no report for 1 s", cart.bot().lostReason().orElseThrow());
    }

    @Test
    void aBlockedCartFailsItsMoveWithTheDistanceCovered() {
        cart.bot().connect();
        cart.block();

        MotionFailed stalled = assertThrows(MotionFailed.class, () -> cart.bot().move(300));

        assertTrue(stalled.getMessage().contains("stalled after 0 mm"), stalled.getMessage());
    }

    @Test
    void theScansOfACartThatDrivesShowTheWallInOnePlace() {
        List<RangeScan> scans = new CopyOnWriteArrayList<>();
        cart.bot().connect();
        cart.bot().addScanListener(scans::add);

        cart.bot().move(300);

        assertTrue(scans.size() > 10, scans.size() + " scans");
        for (RangeScan scan : scans) {
            Pose sonar = scan.odometry().plus(scan.sensor().beams().get(0).mount());
            assertEquals(CartPeer.WALL_MM, sonar.xMm() + scan.rangeMm(0), 2);
        }
    }

    @Test
    void aCartGoesToAPlace() {
        cart.bot().connect();

        new Navigator().goTo(cart.bot(), new Destination(800, 0));

        assertEquals(800, cart.bot().state().pose().xMm(), 30);
    }
}
