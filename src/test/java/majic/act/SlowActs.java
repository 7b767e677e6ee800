package majic.act;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.act.make.ActMaker;
import majic.environment.Settings;

/** Provides a user's act {@code Slow} whose check blocks until {@link #answer()}, as on a network share that hangs. */
public final class SlowActs {
    private final Path folder;
    private final CountDownLatch asked = new CountDownLatch(1);
    private final CountDownLatch answered = new CountDownLatch(1);
    private volatile boolean agreed;

    private SlowActs(Path folder) {
        this.folder = folder;
    }

    /** Writes the act, without consent to its code. */
    public static SlowActs in(Path folder) throws IOException {
        Path source = Files.writeString(
                folder.resolve("Slow.java"),
                "public class Slow extends majic.act.MajicAct { protected void behave() { bot.move(70); } }");
        Files.write(folder.resolve("Slow.act"), ActMaker.from(source).make("Slow", ActDetails.named("Slow")));
        return new SlowActs(folder);
    }

    public ActCatalog acts() {
        return new ActCatalog(folder, new ActTrust(new SlowSettings()));
    }

    /** Waits until the act is being checked. */
    public void awaitCheck() throws InterruptedException {
        asked.await();
    }

    /** Lets the check end: the code may not be run. */
    public void answer() {
        answered.countDown();
    }

    /** Lets the check end: the code may be run. */
    public void agree() {
        agreed = true;
        answered.countDown();
    }

    private final class SlowSettings implements Settings {
        @Override
        public Optional<String> get(String key) {
            asked.countDown();
            try {
                answered.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return agreed ? Optional.of("Slow") : Optional.empty();
        }

        @Override
        public SortedSet<String> keys(String prefix) {
            return new TreeSet<>();
        }

        @Override
        public void put(String key, String value) {
            throw new UnsupportedOperationException();
        }
    }
}
