package majic.aibo.urbi;

import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicInteger;

/** Makes tags that no other client of the same dog has, since {@code stop} acts across clients (URBI sheet 17). */
public final class Tags {
    private final String stem =
            "mj" + Integer.toString(ThreadLocalRandom.current().nextInt(36 * 36 * 36, 36 * 36 * 36 * 36), 36) + "_";
    private final AtomicInteger count = new AtomicInteger();

    /** A tag that was not used before. */
    public String next() {
        return stem + count.incrementAndGet();
    }

    /** The tag for a command that runs at most once at a time. */
    public String named(String name) {
        return stem + name;
    }

    /** The name of a variable on the dog that all connections of this client share and no other client uses. */
    public String sharedVariable(String name) {
        return "majic." + stem + name;
    }
}
