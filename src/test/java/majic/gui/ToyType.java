package majic.gui;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;

/** The type of the robots in the window's tests. */
public final class ToyType implements BotType {
    public final List<ToyBot> made = new CopyOnWriteArrayList<>();
    private final List<Reach> reaches;
    private volatile int port = 4242;
    private volatile BooleanSupplier unlocked = () -> false;

    public ToyType(Reach... reaches) {
        this.reaches = List.of(reaches);
    }

    /** Sets the usual port. */
    public ToyType at(int newPort) {
        port = newPort;
        return this;
    }

    /** Sets when the password is known of toys whose addresses contain "strict". */
    void unlockedIf(BooleanSupplier known) {
        unlocked = known;
    }

    boolean isUnlocked() {
        return unlocked.getAsBoolean();
    }

    @Override
    public String name() {
        return "toy";
    }

    @Override
    public String label() {
        return "Toy";
    }

    @Override
    public String make() {
        return "Playthings Toy";
    }

    @Override
    public List<Reach> reaches() {
        return reaches;
    }

    @Override
    public int defaultPort(String scheme) {
        return port;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        ToyBot bot = new ToyBot(this, address.rest(), environment);
        made.add(bot);
        return bot;
    }

    @Override
    public String advice() {
        return "Wind the toy up.";
    }
}
