package majic.pioneer.parameters;

import java.util.List;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.pioneer.arcos.ArcosCommand;

/** The commands that move the docking mechanism. Like motions they need permission to move. */
final class DockCommands {
    /** Time for the mechanism to reach its contacts, seconds. */
    private static final double CONTACT_S = 5;

    private final PioneerAccess access;

    DockCommands(PioneerAccess access) {
        this.access = access;
    }

    DriverCommand dock() {
        return new DriverCommand(
                "dock",
                List.of(),
                true,
                "lowers the contacts onto the charger below it",
                (none, motion) -> dock(motion));
    }

    DriverCommand undock() {
        return new DriverCommand(
                "undock", List.of(), true, "lifts the contacts off the charger", (none, motion) -> undock(motion));
    }

    private String dock(Motion motion) {
        motion.send(() -> access.send(ArcosCommand.CHARGE.packet(1)));
        return motion.await(this::hasPower, CONTACT_S)
                ? "docked, the charger has power"
                : "contacts lowered; no power from a charger";
    }

    private String undock(Motion motion) {
        boolean docked = hasPower();
        motion.send(() -> access.send(ArcosCommand.CHARGE.packet(0)));
        if (!docked) {
            return "contacts lifted; there was no power from a charger before";
        }
        return motion.await(() -> !hasPower(), CONTACT_S) ? "undocked" : "sent; the charger still has power";
    }

    private boolean hasPower() {
        return access.open().state().power().chargerConnected();
    }
}
