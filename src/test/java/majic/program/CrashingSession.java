package majic.program;

import java.nio.file.Path;
import java.util.Arrays;
import majic.bot.Pose;
import majic.log.Line;
import majic.script.MajicParser;
import majic.team.Team;

/**
 * A program that is to be killed: adds the robots of its arguments, lets them drive, and writes session lines and
 * settings without end. The first argument is the user's folder. Prints each line of the session, and each setting once
 * it is kept.
 */
public final class CrashingSession {
    /** Precedes the number of a setting that is kept. */
    static final String KEPT = "kept ";

    /** The key of the settings that are written. */
    public static final String KEY = "crash.count";

    private static final int PAUSE_MS = 5;
    private static final double MOVED_MM = 5;
    private static final int MOST_MS = 10_000;

    private CrashingSession() {}

    @SuppressWarnings("resource")
    public static void main(String[] arguments) throws Exception {
        Program program = new Program(new UserFolder(Path.of(arguments[0])), null, true);
        program.session().addListener(CrashingSession::print);
        program.announce();
        MajicParser parser = MajicParser.prompt(program.session());
        Arrays.stream(arguments).skip(1).forEach(robot -> parser.parseText("add " + robot));
        parser.awaitAll();
        if (arguments.length > 1) {
            parser.parseText("all drive 100 0 for 60s");
            awaitMoving(program.team());
        }
        for (int count = 0; ; count++) {
            parser.parseText("bots # " + count);
            program.settings().put(KEY, String.valueOf(count));
            System.out.println(KEPT + count);
            Thread.sleep(PAUSE_MS);
        }
    }

    /** Does not wait for ever, because a busy computer may lose a connection. */
    private static void awaitMoving(Team team) throws InterruptedException {
        for (int waitedMs = 0; waitedMs < MOST_MS && !allMove(team); waitedMs += PAUSE_MS) {
            Thread.sleep(PAUSE_MS);
        }
    }

    private static boolean allMove(Team team) {
        return team.members().stream()
                .allMatch(robot -> robot.bot().state().pose().distanceMm(Pose.START) > MOVED_MM);
    }

    private static void print(Line line) {
        if (line.kind() != Line.Kind.COMMAND) {
            System.out.println(line.text());
        }
    }
}
