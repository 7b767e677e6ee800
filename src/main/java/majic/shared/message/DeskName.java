package majic.shared.message;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** The name of a desk for which the user has set none. */
public final class DeskName {
    private static final int LONGEST = 20;
    private static final String UNNAMED = "desk";

    private DeskName() {}

    /**
     * Returns a name for this computer. May ask the system for the name of the computer, which can take a moment.
     *
     * @return the name of the computer without its domain, as far as it can be the name of a desk; {@code desk} if
     *     nothing of it can
     */
    public static String ofThisComputer() {
        try {
            return of(InetAddress.getLocalHost().getHostName());
        } catch (UnknownHostException e) {
            return UNNAMED;
        }
    }

    /** Makes the name of a desk from the name of a computer. */
    static String of(String host) {
        String name =
                host.replaceFirst("\\..*", "").replaceAll("[^\\p{L}\\d_-]", "").replaceFirst("^[^\\p{L}]+", "");
        if (name.isEmpty()) {
            return UNNAMED;
        }
        return name.substring(0, Math.min(LONGEST, name.length()));
    }
}
