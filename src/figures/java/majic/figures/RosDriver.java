package majic.figures;

import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.team.BotFactory;

/**
 * A program that drives one robot through its driver alone. It prints its processor time while the robot only reports
 * and while it is driven, percent of a core, and the moment before each command, {@link System#nanoTime}. Its
 * counterpart for roslibpy is {@code roslibpy_client.py}.
 */
final class RosDriver {
    static final int SETTLING_MS = 15_000;
    static final int MEASURED_MS = 12_000;
    static final int ROUNDS = 40;
    static final int DRIVING_MS = 400;
    static final int STANDING_MS = 600;

    /** Turns on the spot, to and fro. */
    private static final double TURN_DEG_PER_SEC = 30;

    private RosDriver() {}

    /** Connects to the robot of an address, measures and ends. */
    public static void main(String[] arguments) throws InterruptedException {
        BotFactory factory = new BotFactory(BotFactory.types(RosDriver.class.getClassLoader()), Settings.inMemory());
        try (MajicBot bot = factory.create(arguments[0])) {
            bot.connect();
            Thread.sleep(SETTLING_MS);
            ProcessSample began = ProcessSample.now();
            Thread.sleep(MEASURED_MS);
            System.out.println("reporting " + ProcessSample.now().percentSince(began));
            drive(bot, ROUNDS / 8);
            ProcessSample driven = ProcessSample.now();
            drive(bot, ROUNDS);
            System.out.println("driven " + ProcessSample.now().percentSince(driven));
        }
    }

    private static void drive(MajicBot bot, int rounds) throws InterruptedException {
        for (int round = 0; round < rounds; round++) {
            System.out.println("drive " + System.nanoTime());
            bot.drive(0, round % 2 == 0 ? TURN_DEG_PER_SEC : -TURN_DEG_PER_SEC);
            Thread.sleep(DRIVING_MS);
            System.out.println("stop " + System.nanoTime());
            bot.stop();
            Thread.sleep(STANDING_MS);
        }
    }
}
