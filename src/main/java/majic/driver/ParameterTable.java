package majic.driver;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Value;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of one robot, each with how it is read and how it is set. A driver fills it in its constructor, and
 * may add to it while it connects, when it learns what the robot has. Thread-safe.
 */
public final class ParameterTable {
    private final Map<String, Entry> entries = Collections.synchronizedMap(new LinkedHashMap<>());
    private volatile @Nullable LongSupplier usualTime;
    private volatile Map<String, Entry> renewed = Map.of();
    private volatile @Nullable Merged merged;
    private volatile List<Parameter> listed = List.of();
    private volatile Finder finder = name -> Optional.empty();

    /** Creates an empty table; each {@link BotDriver} has one. */
    ParameterTable() {}

    /** Finds parameters that are too many to be listed, such as the fields of all topics of a robot. */
    @FunctionalInterface
    public interface Finder {
        /**
         * Finds a parameter that the table does not have.
         *
         * @param name as it was typed
         * @return its description, whose reader is called with its name; empty if this finder is not meant
         * @throws ParameterException if this finder is meant but has no such parameter; the message lists near ones
         */
        Optional<Found> find(String name);

        /**
         * Lists parameters for completion; a robot may be asked for them in the background. Waits for nothing.
         *
         * @param text how their names begin, in any case
         * @return those that are known so far; empty if this finder is not meant
         */
        default List<Parameter> begunWith(String text) {
            return List.of();
        }

        /**
         * A parameter that was found.
         *
         * @param parameter its description; its name is that which is looked up
         * @param reader gives the present value, as in {@link ParameterTable#add}
         * @param writer sets it, as in {@link Entry#writes}; null if it can only be read
         */
        record Found(
                Parameter parameter,
                Supplier<Value> reader,
                @Nullable Consumer<List<Value>> writer) {
            /**
             * A parameter that can only be read.
             *
             * @param parameter its description
             * @param reader gives the present value
             */
            public Found(Parameter parameter, Supplier<Value> reader) {
                this(parameter, reader, null);
            }
        }
    }

    /** A parameter with its reader and writer. */
    public static final class Entry {
        private volatile Parameter parameter;
        private final @Nullable Supplier<Value> reader;
        private volatile @Nullable BiConsumer<List<Value>, Motion> writer;
        private volatile @Nullable LongSupplier measuredAt;
        private volatile boolean kept;

        private Entry(Parameter parameter, @Nullable Supplier<Value> reader) {
            this.parameter = parameter.access(reader != null, false, false);
            this.reader = reader;
        }

        /**
         * Makes the parameter settable. The writer runs on the thread that sets it.
         *
         * @param newWriter takes the checked values, the parameter's own first, then the given extras in order
         * @return this entry
         */
        public Entry writes(Consumer<List<Value>> newWriter) {
            writer = (values, motion) -> newWriter.accept(values);
            parameter = parameter.access(parameter.readable(), true, false);
            return this;
        }

        /**
         * Makes the parameter settable by a motion: it is refused while the robot is not free, and a stop ends it.
         *
         * @param newWriter takes the checked values and the motion through which everything is to be sent
         * @return this entry
         */
        public Entry moves(BiConsumer<List<Value>, Motion> newWriter) {
            writer = newWriter;
            parameter = parameter.access(parameter.readable(), true, true);
            return this;
        }

        /**
         * Declares that the value is kept by MAJIC, as limits and calibration are: it is no reading, and stays current
         * without a connection.
         *
         * @return this entry
         */
        public Entry kept() {
            kept = true;
            return this;
        }

        /**
         * Gives the time at which the newest value was measured, from which its age follows; otherwise it is as old as
         * the newest state. While the robot is connected, a value older than {@link BotDriver#longestAgeS} is not
         * current.
         *
         * @param nanos returns a time on the clock of the driver; 0 if nothing was measured yet
         * @return this entry
         */
        public Entry measured(LongSupplier nanos) {
            measuredAt = nanos;
            return this;
        }

        boolean isKept() {
            return kept;
        }

        /** Returns when it was measured; null if it is as old as the newest state. */
        @Nullable
        LongSupplier measuredAt() {
            return measuredAt;
        }

        Parameter parameter() {
            return parameter;
        }

        /**
         * Returns what reads the parameter.
         *
         * @throws ParameterException if it can only be set
         */
        Supplier<Value> reader() {
            if (reader == null) {
                throw new ParameterException(parameter.name(), parameter.name() + ": can be set but not read");
            }
            return reader;
        }

        /**
         * Returns what sets the parameter.
         *
         * @throws ParameterException if it can only be read
         */
        BiConsumer<List<Value>, Motion> writer() {
            BiConsumer<List<Value>, Motion> present = writer;
            if (present == null) {
                throw new ParameterException(parameter.name(), parameter.name() + ": can be read but not set");
            }
            return present;
        }
    }

    /**
     * Gives the time of measurement to the entries that are added from now on and give none themselves. For drivers
     * whose readers leave out old values by a rule of their own, it is the present time.
     *
     * @param nanos as for {@link Entry#measured}
     */
    public void measured(LongSupplier nanos) {
        usualTime = nanos;
    }

    /**
     * Adds a parameter that can be read, or replaces the one of the same name.
     *
     * @param parameter its description
     * @param reader gives the present value, waiting for the robot if it must, but never without end; on any thread
     * @return the entry, to make it settable
     */
    public Entry add(Parameter parameter, Supplier<Value> reader) {
        return put(new Entry(parameter, reader));
    }

    /**
     * Adds a parameter that can only be set.
     *
     * @param parameter its description
     * @return the entry, to make it settable
     */
    public Entry addWriteOnly(Parameter parameter) {
        return put(new Entry(parameter, null));
    }

    /**
     * Sets what finds the parameters that are not in the table. One that was found once is in the table from then on.
     *
     * @param newFinder quick, on any thread; waits for nothing
     */
    public void findOthers(Finder newFinder) {
        finder = newFinder;
    }

    /**
     * Describes what depends on the robot that was found: what the call before described and this one does not is gone
     * afterwards. Concurrent readers see either all of the old or all of the new. One of the same name as a parameter
     * added otherwise replaces it.
     *
     * @param description adds the parameters in their order to the table handed to it
     */
    public void renew(Consumer<ParameterTable> description) {
        ParameterTable fresh = new ParameterTable();
        fresh.usualTime = usualTime;
        description.accept(fresh);
        synchronized (entries) {
            renewed = Collections.unmodifiableMap(new LinkedHashMap<>(fresh.entries));
            merged = null;
        }
    }

    private Entry put(Entry entry) {
        entry.measuredAt = usualTime;
        synchronized (entries) {
            entries.put(key(entry.parameter().name()), entry);
            merged = null;
        }
        return entry;
    }

    /**
     * Looks a parameter up.
     *
     * @param bot the name of the robot for the message
     * @param name its name, whatever the case
     * @throws ParameterException if there is none of that name; the message suggests one
     */
    Entry find(String bot, String name) {
        Entry found = merged().find(name);
        if (found == null) {
            found = finder.find(name).map(this::add).orElse(null);
        }
        if (found == null) {
            List<String> names = all().stream().map(Parameter::name).toList();
            throw new ParameterException(
                    name, name + ": " + bot + " has no such parameter" + Suggestion.didYouMean(name, names));
        }
        return found;
    }

    /** Returns those that are not listed and whose names begin with a text, as far as they are known. */
    List<Parameter> begunWith(String text) {
        return finder.begunWith(text);
    }

    private Entry add(Finder.Found found) {
        Entry entry = add(found.parameter(), found.reader());
        Consumer<List<Value>> writer = found.writer();
        return writer == null ? entry : entry.writes(writer);
    }

    /** Returns all; the same list object as long as none changes, so that frequent callers can compare by identity. */
    List<Parameter> all() {
        List<Entry> entriesNow = merged().entries();
        List<Parameter> known = listed;
        if (!describes(known, entriesNow)) {
            known = entriesNow.stream().map(Entry::parameter).toList();
            listed = known;
        }
        return known;
    }

    private static boolean describes(List<Parameter> known, List<Entry> entriesNow) {
        if (known.size() != entriesNow.size()) {
            return false;
        }
        for (int index = 0; index < known.size(); index++) {
            if (known.get(index) != entriesNow.get(index).parameter()) {
                return false;
            }
        }
        return true;
    }

    /** Called for each value that is read, so the entries are merged only after a change. */
    private Merged merged() {
        Merged present = merged;
        if (present == null) {
            synchronized (entries) {
                Map<String, Entry> all = new LinkedHashMap<>(entries);
                all.putAll(renewed);
                present = Merged.of(all);
                merged = present;
            }
        }
        return present;
    }

    /** All entries in their order, and under their names, both as they are described and in lower case. */
    private record Merged(List<Entry> entries, Map<String, Entry> byName) {
        static Merged of(Map<String, Entry> byKey) {
            Map<String, Entry> byName = new HashMap<>(byKey);
            byKey.values().forEach(entry -> byName.put(entry.parameter().name(), entry));
            return new Merged(List.copyOf(byKey.values()), byName);
        }

        @Nullable
        Entry find(String name) {
            Entry exact = byName.get(name);
            return exact == null ? byName.get(key(name)) : exact;
        }
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }
}
