package majic.figures;

import java.util.List;

/** A program with a team whose robots only report. It prints a line when all are connected, and ends with its input. */
final class ReportingTeam {
    static final String CONNECTED = "connected";

    private ReportingTeam() {}

    /** Connects to the robots of the addresses. */
    public static void main(String[] addresses) {
        Measurement.run(() -> {
            try (ConnectedTeam robots = new ConnectedTeam(addresses.length)) {
                robots.team().addListener(new FirstFailure());
                robots.connect(List.of(addresses));
                System.out.println(CONNECTED);
                while (System.in.read() >= 0) {
                    // The program that measures closes this input, which ends also if that program does.
                }
            }
            return List.of();
        });
    }
}
