package majicsim.aibo;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The functions of the server: built-in ones, those of the hardware, and those that programs define. */
final class Functions {
    /** A function that gives its value at once. */
    interface BuiltIn {
        Value call(List<Value> arguments) throws Failure;
    }

    /** A function of the hardware that takes time. */
    interface Lasting {
        Task start(Context context, List<Value> arguments) throws Failure;
    }

    private record Entry(String name, int arity, Lasting body) {}

    private final Map<String, BuiltIn> builtIns = new HashMap<>();
    private final Map<String, Entry> lasting = new HashMap<>();

    void builtIn(String name, BuiltIn function) {
        builtIns.put(name, function);
    }

    void lasting(String name, int arity, Lasting function) {
        lasting.put(name, new Entry(name, arity, function));
    }

    void define(Context context, Definition.Define definition) throws Failure {
        String name = fullName(context, definition.function().text());
        if (lasting.containsKey(name)) {
            throw Failure.of("function " + name + " already exists");
        }
        List<String> parameters = definition.parameters();
        lasting(name, parameters.size(), (call, arguments) -> {
            Frame frame = Objects.requireNonNull(call.frame());
            for (int i = 0; i < parameters.size(); i++) {
                frame.declare(parameters.get(i), arguments.get(i));
            }
            return definition.body().start(call.inner(Parser.NO_TAG));
        });
    }

    void remove(Context context, Name name) {
        lasting.remove(fullName(context, name.text()));
    }

    void removeAllOf(String connectionId) {
        lasting.keySet().removeIf(name -> name.startsWith(connectionId + "."));
    }

    boolean takesTime(Context context, Name function) {
        return lasting.containsKey(fullName(context, function.text()));
    }

    /** The name under which a function is looked up. */
    String key(Context context, Name function) {
        return builtIns.containsKey(function.text()) ? function.text() : fullName(context, function.text());
    }

    /** The body of a function that takes time, on behalf of the context's own frame. */
    Task start(Context context, Name function, List<Value> arguments) throws Failure {
        Entry entry = lasting.get(fullName(context, function.text()));
        if (entry == null) {
            throw unknown(context, function, arguments);
        }
        if (entry.arity() != arguments.size()) {
            throw Failure.of(
                    "invalid number of arguments for " + entry.name() + " (should be " + entry.arity() + " params)");
        }
        return entry.body().start(context, arguments);
    }

    Value builtIn(Context context, Name function, List<Value> arguments) throws Failure {
        BuiltIn builtIn = builtIns.get(function.text());
        if (builtIn == null) {
            throw unknown(context, function, arguments);
        }
        return builtIn.call(arguments);
    }

    /** One line a function, as {@code def} lists them. */
    List<String> listing() {
        return lasting.values().stream()
                .map(entry -> entry.name() + " : " + entry.arity() + " param(s)")
                .toList();
    }

    private static Failure unknown(Context context, Name function, List<Value> arguments) {
        String count = arguments.isEmpty() ? "[no param]" : "[nb param=" + arguments.size() + "]";
        return Failure.inExpression("Error with function eval: " + fullName(context, function.text()) + " " + count);
    }

    private static String fullName(Context context, String name) {
        return name.indexOf('.') >= 0 ? name : context.connection().id() + "." + name;
    }
}
