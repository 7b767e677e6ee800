package majicsim.aibo.urbi;

import java.util.List;

/** The server's first lines: in the form of the real ones (URBI sheet, section 2), newly written. */
final class Banner {
    private static final String RULE = "**********************************************************";

    private Banner() {}

    static List<String> lines() {
        return List.of(
                RULE,
                "URBI Language specif 1.0 - simulated robot",
                "URBI Kernel version 1.0 rev. 153 ",
                "",
                "  URBI Engine 1.0 for a simulated Aibo ERS7",
                "  part of the simulated lab of MAJIC",
                "",
                "This server is a simulation. It answers as the server of",
                "an ERS-7 does, as far as that is known.",
                "",
                RULE);
    }
}
