package majicsim.aibo.urbi.run;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Frame;
import majicsim.aibo.urbi.memory.ObjectTable;
import majicsim.aibo.urbi.syntax.Definition;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** The functions of the server: built-in ones, those of the hardware, and those that programs define. */
public final class Functions {
    /** A function that returns its value at once. */
    @FunctionalInterface
    public interface BuiltIn {
        /**
         * Calls it.
         *
         * @param arguments as many as the program gave
         * @return its value
         * @throws Failure if they do not fit; the program receives its message
         */
        Value call(List<Value> arguments) throws Failure;
    }

    /** A function of the hardware that takes time. */
    @FunctionalInterface
    public interface Lasting {
        /**
         * Starts one call.
         *
         * @param context in which it runs
         * @param arguments as many as it takes
         * @return the task, not started
         * @throws Failure if they do not fit; the program receives its message
         */
        Task start(Context context, List<Value> arguments) throws Failure;
    }

    private record Entry(String name, int arity, boolean resident, Lasting body) {}

    private final Map<String, BuiltIn> builtIns = new HashMap<>();
    private final Map<String, Entry> lasting = new HashMap<>();
    private final ObjectTable objects;
    private long framesMade;

    public Functions(ObjectTable objects) {
        this.objects = objects;
    }

    /**
     * Adds a function of the server or the hardware that returns its value at once.
     *
     * @param name under which every connection calls it
     * @param function the function
     */
    public void builtIn(String name, BuiltIn function) {
        builtIns.put(name, function);
    }

    /**
     * Adds a function of the server or the hardware that takes time.
     *
     * @param name under which every connection calls it
     * @param arity how many arguments it takes
     * @param function the function
     */
    public void lasting(String name, int arity, Lasting function) {
        lasting.put(name, new Entry(name, arity, true, function));
    }

    public void define(Context context, Definition.Define definition) throws Failure {
        String name = fullName(context, definition.function().text());
        if (lasting.containsKey(name)) {
            throw Failure.of("function " + name + " already exists");
        }
        MemoryLimits.checkNames(lasting.size());
        List<String> parameters = definition.parameters();
        Lasting body = (call, arguments) -> {
            for (int i = 0; i < parameters.size(); i++) {
                call.variables().declare(call.scope(), parameters.get(i), arguments.get(i));
            }
            return call.inner(Statement.NO_TAG).start(definition.body());
        };
        lasting.put(name, new Entry(name, parameters.size(), false, body));
    }

    /** Removes a function; returns false if there was none. */
    public boolean remove(Context context, Name name) {
        return lasting.remove(fullName(context, name.text())) != null;
    }

    /** Removes the functions that programs defined. */
    public void forget() {
        lasting.values().removeIf(entry -> !entry.resident());
    }

    public void removeAllOf(String connectionId) {
        lasting.keySet().removeIf(name -> name.startsWith(connectionId + "."));
    }

    public boolean takesTime(Context context, Name function) {
        return find(context, function) != null;
    }

    /** The frame of a new call, with the object of the function or none. */
    Frame frame(Context context, Name function) {
        String name = fullName(context, function.text());
        String object = name.substring(0, Math.max(0, name.indexOf('.')));
        return new Frame("__UFnct" + ++framesMade, objects.contains(object) ? object : "");
    }

    /** The name under which a function is looked up. */
    String key(Context context, Name function) {
        return builtIns.containsKey(function.text()) ? function.text() : fullName(context, function.text());
    }

    /** The body of a function that takes time; program text that the server runs has no frame but the caller's. */
    Task start(Context caller, Frame frame, Name function, List<Value> arguments) throws Failure {
        Entry entry = find(caller, function);
        if (entry == null) {
            throw unknown(caller, function, arguments);
        }
        if (entry.arity() != arguments.size()) {
            throw Failure.of(
                    "invalid number of arguments for " + entry.name() + " (should be " + entry.arity() + " params)");
        }
        boolean framed = entry.name().indexOf('.') >= 0;
        return entry.body().start(framed ? caller.withFrame(frame) : caller, arguments);
    }

    Value builtIn(Context context, Name function, List<Value> arguments) throws Failure {
        BuiltIn builtIn = builtIns.get(function.text());
        if (builtIn == null) {
            throw unknown(context, function, arguments);
        }
        return builtIn.call(arguments);
    }

    /** One line a function, as {@code def} lists them; those that only the lab has are left out. */
    public List<String> listing() {
        return lasting.values().stream()
                .filter(entry -> entry.name().indexOf('.') >= 0 && !entry.name().startsWith("lab."))
                .map(entry -> entry.name() + " : " + entry.arity() + " param(s)")
                .toList();
    }

    private @Nullable Entry find(Context context, Name function) {
        Entry own = lasting.get(function.text());
        if (own != null) {
            return own;
        }
        for (String place : objects.places(fullName(context, function.text()))) {
            Entry found = lasting.get(place);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private static Failure unknown(Context context, Name function, List<Value> arguments) {
        String count = arguments.isEmpty() ? "[no param]" : "[nb param=" + arguments.size() + "]";
        return Failure.inExpression("Error with function eval: " + fullName(context, function.text()) + " " + count);
    }

    private static String fullName(Context context, String written) {
        String name = ObjectTable.resolve(context.scope(), written);
        return name.indexOf('.') >= 0 ? name : context.connection().id() + "." + name;
    }
}
