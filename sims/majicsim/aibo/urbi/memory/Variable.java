package majicsim.aibo.urbi.memory;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * A variable: what was assigned last, and, where hardware stands behind it, what that measures. Numbers are clipped to the range
 * silently (URBI sheet, section 6).
 */
public final class Variable {
    /** The hardware behind a variable. */
    @FunctionalInterface
    public interface Hardware {
        /**
         * Measures, whenever the variable is read.
         *
         * @return what it measures now
         */
        Value measure();

        /**
         * The command was set.
         *
         * @param target in the variable's unit, already clipped
         */
        default void command(double target) {}

        /**
         * It was given bytes.
         *
         * @param binary the bytes and their description
         */
        default void receive(Value.Binary binary) {}

        /**
         * Whether it moves, so that derivatives of it make sense, and a reset of the server leaves it where it is.
         *
         * @return true for a joint
         */
        default boolean moves() {
            return false;
        }
    }

    /** An assignment that takes time. */
    @FunctionalInterface
    public interface Motion {
        /** Ends it where it is. */
        void cancel();
    }

    private final String name;
    private final Properties properties = new Properties();
    private final Derivative profile = new Derivative();
    private final Derivative measured = new Derivative();
    private final List<Motion> motions = new ArrayList<>();
    private final @Nullable Hardware hardware;
    private Value target;
    private long lastPass = -1;
    private double sum;
    private int writers;
    private final Properties keptProperties = new Properties();
    private Value kept = Value.VOID;

    /**
     * A variable without hardware.
     *
     * @param name its full name, with a dot
     * @param value what it has first
     */
    public Variable(String name, Value value) {
        this(name, value, null);
    }

    /**
     * A variable that may have hardware behind it.
     *
     * @param name its full name, with a dot
     * @param value its first command, which is not passed to the hardware
     * @param hardware what is read and commanded through it; null for none
     */
    public Variable(String name, Value value, @Nullable Hardware hardware) {
        this.name = name;
        this.target = value;
        this.hardware = hardware;
    }

    public String name() {
        return name;
    }

    public Properties properties() {
        return properties;
    }

    /**
     * Clips numbers that are assigned from now on, silently (URBI sheet, section 6).
     *
     * @param min the least, in its unit
     * @param max the most
     */
    public void limit(double min, double max) {
        properties.range(min, max);
    }

    /**
     * Sets the effect of several assignments at the same time.
     *
     * @param mode how they are blended from now on
     */
    public void blend(Blend mode) {
        properties.blend(mode);
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

    public boolean isDevice() {
        return hardware != null;
    }

    /** The assignments with modifiers that are under way on it. */
    public List<Motion> motions() {
        return motions;
    }

    public Value read() {
        return hardware == null ? target : hardware.measure();
    }

    /**
     * What was assigned last.
     *
     * @return the command, which hardware may still be on its way to
     */
    public Value target() {
        return target;
    }

    /**
     * Assigns a value at once, and passes it to the hardware.
     *
     * @param value numbers are clipped to the limits
     */
    public void write(Value value) {
        target = value instanceof Value.Num num ? Value.of(properties.clip(num.number())) : value;
        if (hardware != null && target instanceof Value.Num num) {
            hardware.command(num.number());
        } else if (hardware != null && value instanceof Value.Binary binary) {
            hardware.receive(binary);
        }
    }

    /**
     * Assigns a number of which there may be several at the same time: they are averaged, added, or the last one counts.
     *
     * @param value in its unit
     * @param pass the kernel's; those of the same one are blended
     */
    public void submit(double value, long pass) {
        if (pass != lastPass) {
            lastPass = pass;
            sum = 0;
            writers = 0;
        }
        sum += value;
        writers++;
        write(Value.of(properties.blend().combine(value, sum, writers)));
    }

    public double normalized() throws Failure {
        return properties.normalize(name, read().number());
    }

    public Derivative profile() {
        return profile;
    }

    public Derivative measured() {
        return measured;
    }

    /** Takes a sample for the derivatives. */
    public void sample(double seconds) {
        if (hardware == null || !hardware.moves()) {
            return;
        }
        if (target instanceof Value.Num num && read() instanceof Value.Num now) {
            profile.sample(num.number(), seconds);
            measured.sample(now.number(), seconds);
        }
    }
}
