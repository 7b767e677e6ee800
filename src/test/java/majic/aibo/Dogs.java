package majic.aibo;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotEnvironment;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.bot.TimeSource;

/** A scripted dog that stands with its motors on, and its driver. */
final class Dogs implements AutoCloseable {
    final ScriptedDog dog = new ScriptedDog();
    final MajicAibo aibo = new MajicAibo(dog.address(), new BotEnvironment(TimeSource.system(), Settings.inMemory()));
    final List<String> notices = new CopyOnWriteArrayList<>();

    Dogs() throws IOException {
        dog.set("robot.MyguessPosition()", "\"stand\"");
        dog.set("legLF1.load", "1.000000");
        aibo.addListener(new BotListener() {
            @Override
            public void notice(MajicBot bot, String message) {
                notices.add(message);
            }
        });
    }

    /** Begins something on a thread of its own. */
    static CompletableFuture<Void> aside(Runnable work) {
        return CompletableFuture.runAsync(work, task -> new Thread(task).start());
    }

    /** Waits until something is so; for ever, so tests have a time-out. */
    static void until(BooleanSupplier so) {
        Watch watch = new Watch(TimeSource.system(), TimeSource.system().signal());
        while (!so.getAsBoolean()) {
            watch.await(() -> false, 0.02);
        }
    }

    @Override
    public void close() throws IOException {
        aibo.close();
        dog.close();
    }
}
