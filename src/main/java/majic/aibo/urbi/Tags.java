package majic.aibo.urbi;

import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicInteger;

/** Makes tags that no other client of the same dog has, since {@code stop} acts across clients (URBI sheet 17). */
public final class Tags {
    private final String stem =
            "mj" + Integer.toString(ThreadLocalRandom.current().nextInt(36 * 36 * 36, 36 * 36 * 36 * 36), 36) + "_";
    private final AtomicInteger count = new AtomicInteger();

    /** A tag never given out before. */
    public String next() {
        return stem + count.incrementAndGet();
    }

    /** The tag for something there is one of. */
    public String named(String name) {
        return stem + name;
    }

    /** A name for a variable all connections share, which no other client uses. */
    public String sharedVariable(String name) {
        return "majic." + stem + name;
    }
}
