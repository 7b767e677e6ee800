package majicsim.aibo;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A variable: what was assigned last, and, where hardware stands behind it, what that measures. Numbers are clipped to the range
 * silently (URBI sheet, section 6).
 */
final class Variable {
    /** The hardware behind a variable. */
    interface Hardware {
        /** What it measures now. */
        Value measure();

        /** The command was set to this; already clipped. */
        default void command(double target) {}

        /** It was given bytes. */
        default void receive(Value.Binary binary) {}

        /** Whether it moves, so that derivatives of it make sense. */
        default boolean moves() {
            return false;
        }
    }

    private final String name;
    private final Properties properties = new Properties();
    private final Derivative profile = new Derivative();
    private final Derivative measured = new Derivative();
    private final List<Task> motions = new ArrayList<>();
    private final @Nullable Hardware hardware;
    private Value target;
    private long lastPass = -1;
    private double sum;
    private int writers;
    private final Properties keptProperties = new Properties();
    private Value kept = Value.VOID;

    Variable(String name, Value value) {
        this(name, value, null);
    }

    Variable(String name, Value value, @Nullable Hardware hardware) {
        this.name = name;
        this.target = value;
        this.hardware = hardware;
    }

    String name() {
        return name;
    }

    Properties properties() {
        return properties;
    }

    /** Remembers for {@link #restore} how it is now. */
    void keep() {
        keptProperties.take(properties);
        kept = target;
    }

    /** Becomes as it was kept, and the hardware with it; but what moves stays where it is. */
    void restore() {
        properties.take(keptProperties);
        if (hardware == null) {
            target = kept;
        } else if (!hardware.moves()) {
            write(kept);
        }
    }

    boolean isDevice() {
        return hardware != null;
    }

    /** The assignments with modifiers that are under way on it. */
    List<Task> motions() {
        return motions;
    }

    Value read() {
        return hardware == null ? target : hardware.measure();
    }

    Value target() {
        return target;
    }

    void write(Value value) {
        target = value instanceof Value.Num num ? Value.of(properties.clip(num.number())) : value;
        if (hardware != null && target instanceof Value.Num num) {
            hardware.command(num.number());
        } else if (hardware != null && value instanceof Value.Binary binary) {
            hardware.receive(binary);
        }
    }

    /** Writes in one pass of the kernel are blended: averaged, added, or the last one counts. */
    void submit(double value, long pass) {
        if (pass != lastPass) {
            lastPass = pass;
            sum = 0;
            writers = 0;
        }
        sum += value;
        writers++;
        write(Value.of(properties.blend().combine(value, sum, writers)));
    }

    double normalized() throws Failure {
        return properties.normalize(name, Operators.number(read()));
    }

    Derivative profile() {
        return profile;
    }

    Derivative measured() {
        return measured;
    }

    /** Takes a sample for the derivatives. */
    void sample(double seconds) {
        if (hardware == null || !hardware.moves()) {
            return;
        }
        if (target instanceof Value.Num num && read() instanceof Value.Num now) {
            profile.sample(num.number(), seconds);
            measured.sample(now.number(), seconds);
        }
    }
}
