package majic.hemisson;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.MajicBot;

/** A driver and the robot that it drives, for one test. */
final class DrivenHemisson implements AutoCloseable {
    /** The proximity readings of a robot with nothing around it. */
    static final String FAR = "n,004,004,004,004,004,004,060,080";

    /** The proximity readings with an obstacle ahead. */
    static final String NEAR = "n,060,004,004,004,004,004,060,080";

    /** The greeting of a robot that is switched on. */
    static final String GREETING =
            "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30\r\nE-Mail : info@hemisson.com\r\n\r\n";

    private final List<String> notices = new CopyOnWriteArrayList<>();
    private final ScriptedHemisson robot;
    private final MajicHemisson bot;

    DrivenHemisson() {
        robot = new ScriptedHemisson();
        bot = new MajicHemisson(new BotAddress("hemisson", robot.address()), robot.environment());
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot source, String message) {
                notices.add(message);
            }
        });
    }

    ScriptedHemisson robot() {
        return robot;
    }

    MajicHemisson bot() {
        return bot;
    }

    List<String> notices() {
        return notices;
    }

    /** Runs an action as soon as the robot has received the command to drive. */
    CompletableFuture<Void> onceItMoves(Runnable deed) {
        return robot.clock().aside(() -> {
            await(() -> robot.count("D,3,3") == 1);
            deed.run();
        });
    }

    void hangUp() {
        try {
            robot.hangUp();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    void switchOffAndOn() {
        try {
            robot.say("HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Receives everything, but answers nothing from the first motion on. */
    void fallSilentWhenMoving() {
        robot.answer('D', command -> {
            robot.fallSilent(!command.equals("D,0,0"));
            return "d";
        });
    }

    /** Whether the robot has received a command to drive, and no stop since. */
    boolean isMoving() {
        return robot.count("D,3,3") > 0 && !afterMotion().contains("D,0,0");
    }

    /** The commands that the robot received after the first motion. */
    List<String> afterMotion() {
        List<String> all = robot.commands();
        return all.subList(all.indexOf("D,3,3") + 1, all.size());
    }

    /** The time at which a command was first received. */
    long heardAt(String command) {
        return robot.heard().stream()
                .filter(heard -> heard.command().equals(command))
                .findFirst()
                .orElseThrow()
                .nanos();
    }

    /** From a command to the next of another kind. */
    long millisBetween(String first, String second) {
        long from = heardAt(first);
        return robot.heard().stream()
                .filter(heard -> heard.command().equals(second) && heard.nanos() > from)
                .mapToLong(heard -> (heard.nanos() - from) / 1_000_000)
                .findFirst()
                .orElseThrow();
    }

    /** Lets time pass until a condition holds; without a limit of its own. */
    void await(BooleanSupplier condition) {
        robot.clock().until(condition);
    }

    @Override
    public void close() throws IOException {
        bot.close();
        robot.close();
    }
}
