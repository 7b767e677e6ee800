package majicsim.pioneer.session;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.Argument;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.pioneer.report.ConfigReport;
import org.jspecify.annotations.Nullable;

/**
 * SIM_CTRL and similar commands for the simulator itself (ARCOS sheet 6.2). One client may not change the room of all
 * robots, so a request for a map is answered as not changed, and the map is never opened.
 */
final class SimControl {
    private static final System.Logger LOG = System.getLogger(SimControl.class.getName());
    private static final int LOAD_MAP = 1;
    private static final int LOAD_MAP_AS_MASTER = 2;
    private static final int LOG_STATE = 5;
    private static final int SIM_INFO = 6;

    private static final int MAP_CHANGED_TYPE = 0x66;
    private static final int SIM_INFO_TYPE = 0x63;
    private static final int BY_A_CLIENT = 0;
    private static final int NOT_CHANGED = 0;

    private SimControl() {}

    /** SIM_EXIT: ignored, because other clients may use the lab. */
    static void refuseToEnd() {
        LOG.log(System.Logger.Level.INFO, "pioneer: a client asked the simulator to end; it goes on");
    }

    /** SIM_MESSAGE: writes to the log, without control characters. */
    static void show(String text) {
        String printable = text.replaceAll("[^\\x20-\\x7E]", "?");
        LOG.log(System.Logger.Level.INFO, "pioneer: message from the client: {0}", printable);
    }

    /** Executes the command; returns the answer's packet, or null. */
    static byte @Nullable [] answer(Argument order, Board board, SimLaser laser) {
        int operation = order.integer();
        switch (operation) {
            case LOAD_MAP, LOAD_MAP_AS_MASTER -> {
                LOG.log(System.Logger.Level.INFO, "pioneer: a client asked for another map; the room stays as it is");
                return new PacketWriter(MAP_CHANGED_TYPE)
                        .uint8(BY_A_CLIENT)
                        .uint8(NOT_CHANGED)
                        .text(order.textBehindNumber())
                        .toBytes();
            }
            case SIM_INFO -> {
                return simInfo(board, laser);
            }
            case LOG_STATE ->
                LOG.log(
                        System.Logger.Level.INFO,
                        "pioneer: odometry {0}, motors {1}",
                        board.drive().odometry(),
                        board.drive().isEnabled() ? "on" : "off");
            default -> LOG.log(System.Logger.Level.DEBUG, "pioneer: ignored SIM_CTRL {0}", operation);
        }
        return null;
    }

    /** Name and version of the simulator, feature flags, and its devices with number and whether they are on. */
    private static byte[] simInfo(Board board, SimLaser laser) {
        PacketWriter packet = new PacketWriter(SIM_INFO_TYPE)
                .text("majicsim")
                .text(ConfigReport.VERSION)
                .int32(0)
                .int32(laser.isThere() ? 2 : 1);
        device(packet, "sonar", board.sonar().arraysOn() != 0);
        if (laser.isThere()) {
            device(packet, "laser", laser.isOn());
        }
        return packet.toBytes();
    }

    private static void device(PacketWriter packet, String name, boolean on) {
        packet.text(name).text(name).uint8(0).int32(on ? 1 : 0);
    }
}
