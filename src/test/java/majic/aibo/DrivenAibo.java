package majic.aibo;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.environment.Settings;

/** A scripted dog and its driver, for one test. */
final class DrivenAibo implements AutoCloseable {
    final ScriptedDog dog;
    final Settings settings = Settings.inMemory();
    final MajicAibo aibo;
    final List<String> notices = new CopyOnWriteArrayList<>();

    private DrivenAibo(ScriptedDog dog) {
        this.dog = dog;
        this.aibo = new MajicAibo(new BotAddress("aibo", dog.address()), dog.environment(settings));
        aibo.addListener(new BotListener() {
            @Override
            public void notice(MajicBot bot, String message) {
                notices.add(message);
            }
        });
    }

    /** Creates a dog that lies with its motors off, on a stepped clock. */
    static DrivenAibo lying() {
        return new DrivenAibo(new ScriptedDog());
    }

    /** Creates a dog that stands with its motors on, on a stepped clock. */
    static DrivenAibo standing() {
        return standing(new ScriptedDog());
    }

    /** Creates a dog that stands with its motors on, on the system's clock. */
    static DrivenAibo standingInRealTime() {
        return standing(ScriptedDog.inRealTime());
    }

    private static DrivenAibo standing(ScriptedDog dog) {
        dog.set("robot.MyguessPosition()", "\"stand\"");
        dog.set("legLF1.load", "1.000000");
        return new DrivenAibo(dog);
    }

    DrivenAibo connected() {
        aibo.connect();
        return this;
    }

    /** Starts a task on its own thread. */
    CompletableFuture<Void> aside(Runnable work) {
        return dog.clock().aside(work);
    }

    /** Lets time pass until a task of {@link #aside} is done. */
    void join(CompletableFuture<Void> begun) {
        dog.clock().join(begun);
    }

    /** Lets time pass until a condition is true; without a limit of its own. */
    void until(BooleanSupplier so) {
        dog.clock().until(so);
    }

    @Override
    public void close() throws IOException {
        aibo.close();
        dog.close();
    }
}
