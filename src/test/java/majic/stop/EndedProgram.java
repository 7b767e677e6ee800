package majic.stop;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import majic.aibo.MajicAibo;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.hemisson.MajicHemisson;
import majic.pioneer.MajicPioneer;

/**
 * A program that embeds one robot, moves it and closes nothing. Moves a metre, or drives at a given speed. Prints a
 * line once the robot moves; ends when it reads a line.
 */
final class EndedProgram {
    /** The beginning of the line that is printed if the robot could not be connected. */
    static final String NOT_CONNECTED = "not connected: ";

    private EndedProgram() {}

    @SuppressWarnings("resource")
    public static void main(String[] args) throws Exception {
        MajicBot bot = create(args[0]);
        CountDownLatch moving = new CountDownLatch(1);
        bot.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot robot, BotState state) {
                if (state.moving()) {
                    moving.countDown();
                }
            }
        });
        connect(bot);
        Thread driving = new Thread(() -> {
            if (args.length == 1) {
                bot.move(1000);
            } else {
                drive(bot, Double.parseDouble(args[1]));
            }
        });
        driving.setDaemon(true);
        driving.start();
        moving.await();
        System.out.println("moving");
        exitWhenTold();
    }

    private static void connect(MajicBot bot) {
        try {
            bot.connect();
        } catch (ConnectFailed e) {
            System.out.println(NOT_CONNECTED + e.getMessage());
            System.exit(1);
        }
    }

    private static void drive(MajicBot bot, double mmPerSec) {
        try {
            bot.drive(mmPerSec, 0, 40, Guard.NEVER);
        } catch (MotionFailed e) {
            System.out.println("failed: " + e.getMessage());
        }
    }

    private static void exitWhenTold() throws IOException {
        if (System.in.read() >= 0) {
            System.exit(0);
        }
    }

    private static MajicBot create(String address) {
        return switch (address.substring(0, address.indexOf(':'))) {
            case "pioneer" -> new MajicPioneer(address);
            case "aibo" -> new MajicAibo(address);
            case "hemisson" -> new MajicHemisson(address);
            default -> new MuteCart(BotAddress.parse(address).rest());
        };
    }
}
