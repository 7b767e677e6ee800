import majic.script.MajicParser;
import majic.script.Session;
import majic.team.Team;
import majic.time.TimeSource;

/** Commands a team of robots in MAJIC Script, without a window. */
public final class TwentyLines {
    private TwentyLines() {}

    /**
     * Runs the lines that it is given, then ends.
     *
     * @param lines MAJIC Script, such as {@code "add pioneer://localhost" "1 move 300" "1 get distanceFront"}
     * @throws InterruptedException if it is interrupted while robots move
     */
    public static void main(String[] lines) throws InterruptedException {
        try (Team team = new Team(TimeSource.system())) {
            Session session = Session.of(team);
            session.addListener(line -> System.out.println(line.text()));
            MajicParser parser = MajicParser.pipe(session);
            for (String line : lines) {
                parser.parseText(line);
            }
            parser.awaitAll();
        }
    }
}
