package majicsim.aibo.urbi;

import java.util.List;

/** The server's first lines: in the form of the real ones (URBI sheet, section 2), newly written. */
final class Banner {
    private static final String RULE = "**********************************************************";

    private Banner() {}

    static List<String> lines() {
        return List.of(
                RULE,
                "URBI Language specif 1.0 - as a simulated robot speaks it",
                "URBI Kernel version 1.0 rev. 153 ",
                "",
                "  URBI Engine 1.0 for a simulated Aibo ERS7",
                "  written for the MAJIC lab after the protocol sheet",
                "",
                "This dog lives in a room of numbers: it cannot bite,",
                "fall or run out of floor. What it answers is what the",
                "real one would answer, as far as we know.",
                "",
                RULE);
    }
}
