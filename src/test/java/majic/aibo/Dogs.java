package majic.aibo;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotListener;
import majic.bot.MajicBot;

/** A scripted dog that stands with its motors on, and its driver. */
final class Dogs implements AutoCloseable {
    final ScriptedDog dog = new ScriptedDog();
    final MajicAibo aibo = new MajicAibo(dog.address(), dog.environment());
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
    CompletableFuture<Void> aside(Runnable work) {
        return dog.clock().aside(work);
    }

    /** Waits for what was begun aside. */
    void join(CompletableFuture<Void> begun) {
        dog.clock().join(begun);
    }

    /** Waits until something is so; for ever, so tests have a time-out. */
    void until(BooleanSupplier so) {
        dog.clock().until(so);
    }

    @Override
    public void close() throws IOException {
        aibo.close();
        dog.close();
    }
}
