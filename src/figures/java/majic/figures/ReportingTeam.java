package majic.figures;

import java.util.List;

/**
 * A program with a team whose robots only report. It obeys its input, answers each command, and ends with its input.
 */
final class ReportingTeam {
    static final char CONNECT = '+';
    static final char DISCONNECT = '-';
    static final String CONNECTED = "connected";
    static final String DISCONNECTED = "disconnected";

    private ReportingTeam() {}

    /** Connects to the robots of the addresses, and disconnects from them, as often as the input demands it. */
    public static void main(String[] addresses) {
        Measurement.run(() -> {
            // The program that measures closes this input, which ends also if that program does.
            while (System.in.read() == CONNECT) {
                try (ConnectedTeam robots = new ConnectedTeam(addresses.length)) {
                    robots.team().addListener(new FirstFailure());
                    robots.connect(List.of(addresses));
                    System.out.println(CONNECTED);
                    System.in.read();
                }
                System.out.println(DISCONNECTED);
            }
            return List.of();
        });
    }
}
