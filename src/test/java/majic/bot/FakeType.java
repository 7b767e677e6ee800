package majic.bot;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import majic.environment.BotEnvironment;

/** A type of robot that is made up for tests: {@code fake://anything}. */
public class FakeType implements BotType {
    private final String name;
    private final Map<String, FakeBot> made = new ConcurrentHashMap<>();
    private volatile boolean broken;
    private volatile Runnable whenNamed = () -> {};
    private volatile Consumer<FakeBot> preparation = bot -> {};

    public FakeType() {
        this("fake");
    }

    public FakeType(String name) {
        this.name = name;
    }

    /** What happens to every robot before it is handed out, for instance to make its connection hang. */
    public FakeType prepare(Consumer<FakeBot> newPreparation) {
        preparation = newPreparation;
        return this;
    }

    /** The robot that was made for an address. */
    public FakeBot made(String address) {
        return made.get(address);
    }

    /** Makes it a type that breaks down when it is asked for its name, as no plug-in should. */
    public void breakDown() {
        broken = true;
    }

    /** Runs an event once, during a later reading of the name: while a line that names the type finds its robots. */
    public void duringName(int reading, Runnable event) {
        AtomicInteger left = new AtomicInteger(reading);
        whenNamed = () -> {
            if (left.decrementAndGet() == 0) {
                event.run();
            }
        };
    }

    @Override
    public String name() {
        whenNamed.run();
        if (broken) {
            throw new IllegalStateException("a mistake in a plug-in");
        }
        return name;
    }

    @Override
    public String label() {
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    @Override
    public String make() {
        return "Made-up " + label();
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP, Reach.SERIAL);
    }

    @Override
    public int defaultPort(String scheme) {
        return 1234;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        FakeBot bot = new FakeBot(this, environment);
        preparation.accept(bot);
        made.put(address.rest(), bot);
        return bot;
    }

    @Override
    public String advice() {
        return "Imagine it harder.";
    }
}
