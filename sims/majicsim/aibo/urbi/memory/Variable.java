package majicsim.aibo.urbi.memory;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * A variable: the value assigned last and, if it belongs to hardware, the measured value. Numbers are clipped to the
 * range silently (URBI sheet, section 6).
 */
public final class Variable {
    /** The hardware behind a variable. */
    @FunctionalInterface
    public interface Hardware {
        /**
         * Measures; called whenever the variable is read.
         *
         * @return the measured value
         */
        Value measure();

        /**
         * Takes a new command.
         *
         * @param target in the variable's unit, already clipped
         */
        default void command(double target) {}

        /**
         * Takes bytes.
         *
         * @param binary the bytes and their description
         */
        default void receive(Value.Binary binary) {}

        /**
         * Whether it moves; then it has derivatives, and a reset of the server does not move it.
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
        /** Ends it at the present value. */
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
     * @param value its first value
     */
    public Variable(String name, Value value) {
        this(name, value, null);
    }

    /**
     * A variable that may have hardware behind it.
     *
     * @param name its full name, with a dot
     * @param value its first command, which is not passed to the hardware
     * @param hardware the hardware that it reads and commands; null for none
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
     * Sets the effect of simultaneous assignments.
     *
     * @param mode how they are combined
     */
    public void blend(Blend mode) {
        properties.blend(mode);
    }

    /** Stores its present state for {@link #restore}. */
    void keep() {
        keptProperties.take(properties);
        kept = target;
    }

    /** Restores the stored state, also that of its hardware, unless the hardware moves. */
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
     * The value assigned last.
     *
     * @return the command, which the hardware may not have reached yet
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
     * Assigns one of several simultaneous numbers: they are averaged, added, or the last one counts.
     *
     * @param value in its unit
     * @param pass the kernel's pass; the numbers of the same pass are combined
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

    /** Whether it has derivatives. */
    boolean moves() {
        return hardware != null && hardware.moves();
    }

    /** Takes a sample for the derivatives, of a variable that moves. */
    public void sample(double seconds) {
        if (target instanceof Value.Num num && read() instanceof Value.Num now) {
            profile.sample(num.number(), seconds);
            measured.sample(now.number(), seconds);
        }
    }
}
