package majicsim.aibo.urbi.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Events;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Operators;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** Evaluates expressions for one command. It changes only variables that take an event's arguments. */
public final class Evaluator implements Expr.Evaluation {
    /** Stands before each index in the name of a variable. */
    private static final String INDEX = "__";

    private final Context context;
    private final @Nullable Map<Expr.Variable, Value> fixed;

    /**
     * Evaluates for one command.
     *
     * @param context of the command
     */
    public Evaluator(Context context) {
        this(context, null);
    }

    /** @param fixed the static variables that were read already, by identity; null if nothing is evaluated again */
    public Evaluator(Context context, @Nullable Map<Expr.Variable, Value> fixed) {
        this.context = context;
        this.fixed = fixed;
    }

    public List<Value> values(List<Expr> exprs) throws Failure {
        List<Value> values = new ArrayList<>();
        for (Expr expr : exprs) {
            values.add(expr.value(this));
        }
        return values;
    }

    /** The value of a static variable when the command first read it (URBI sheet, section 21). */
    @Override
    public Value fixed(Expr.Variable expr) throws Failure {
        Value known = fixed == null ? null : fixed.get(expr);
        if (known != null) {
            return known;
        }
        Value value = variable(expr.name());
        if (fixed != null) {
            fixed.put(expr, value);
        }
        return value;
    }

    @Override
    public Value variable(Name name) throws Failure {
        String key = key(name);
        Memory memory = context.memory();
        Variable known = memory.variables().find(context.scope(), key);
        if (known == null) {
            String full = memory.variables().fullName(context.scope(), key);
            if (memory.events().isKnown(full)) {
                return Value.of(memory.events().current(full) != null);
            }
            if (memory.objects().contains(key)) {
                return new Value.Obj(memory.variables().fields(key));
            }
            Value.Items list = indexed(key);
            if (list != null) {
                return item(list, key);
            }
        }
        return suffixed(known == null ? known(key, Failure.of()) : known, name.suffix());
    }

    @Override
    public Value property(Expr.Property property) throws Failure {
        String key = key(property.name());
        return known(key, Failure.inExpression()).properties().read(property.property());
    }

    @Override
    public Value items(Expr.Items list) throws Failure {
        return MemoryLimits.checked(new Value.Items(values(list.parts())));
    }

    @Override
    public Value members(String group) {
        List<String> leaves = context.memory().groups().leaves(group);
        return new Value.Items(leaves.stream().map(Value::of).toList());
    }

    @Override
    public Value binary(Expr.Binary expr) throws Failure {
        return Operators.apply(
                expr.operator(), expr.left().value(this), expr.right().value(this));
    }

    @Override
    public Value unary(Expr.Unary expr) throws Failure {
        Value operand = expr.operand().value(this);
        return expr.operator().equals("!") ? Value.of(!operand.isTrue()) : Value.of(-operand.number());
    }

    @Override
    public Value call(Expr.Call call) throws Failure {
        String event = context.variables().fullName(context.scope(), key(call.function()));
        if (context.memory().events().isKnown(event)) {
            return Value.of(matches(context.memory().events().current(event), call.parts()));
        }
        String function = context.functions().key(context, call.function());
        boolean asksOfName = function.equals("isdef") || function.equals("isvoid");
        if (asksOfName && call.parts().size() == 1 && call.parts().get(0) instanceof Expr.Variable variable) {
            return about(function, variable.name());
        }
        if (context.functions().takesTime(context, call.function())) {
            throw Failure.inExpression("Custom function call in expressions not allowed in kernel 1");
        }
        return context.functions().builtIn(context, call.function(), values(call.parts()));
    }

    /** The key under which a name's variable is stored. */
    public String key(Name name) throws Failure {
        String text = name.computed() == null
                ? name.text()
                : name.computed().value(this).join();
        if (name.index().isEmpty()) {
            return text;
        }
        StringBuilder key = new StringBuilder(text);
        for (Value index : values(name.index())) {
            key.append(INDEX).append(index.join());
        }
        return key.toString();
    }

    /**
     * What a shared variable holds.
     *
     * @param name with a dot
     * @return its number
     * @throws Failure if there is none, or no number in it
     */
    public double number(String name) throws Failure {
        return variable(Name.of(name)).number();
    }

    /** The variable that an assignment to that name writes; with {@code make} it is created if missing. */
    public Variable target(Name name, boolean make) throws Failure {
        return context.variables().target(context.scope(), key(name), make);
    }

    /** Whether an event with fitting arguments is emitted; a name among the arguments takes the event's value. */
    private boolean matches(Events.@Nullable Event event, List<Expr> pattern) throws Failure {
        if (event == null || event.arguments().size() != pattern.size()) {
            return false;
        }
        for (int i = 0; i < pattern.size(); i++) {
            Value came = event.arguments().get(i);
            if (pattern.get(i) instanceof Expr.Variable variable) {
                context.variables().assign(context.scope(), key(variable.name()), came);
            } else if (!pattern.get(i).value(this).equals(came)) {
                return false;
            }
        }
        return true;
    }

    private Value about(String function, Name name) throws Failure {
        Variable variable = context.variables().find(context.scope(), key(name));
        boolean isVoid = variable == null || variable.read() instanceof Value.Void;
        boolean isDefined = variable != null || context.functions().takesTime(context, name);
        return Value.of(function.equals("isdef") ? isDefined : isVoid);
    }

    /**
     * The list to which the last index of a name belongs: the kernel first takes {@code l[0]} as the name {@code l__0}.
     */
    private Value.@Nullable Items indexed(String key) {
        int index = key.lastIndexOf(INDEX);
        Variable variable = index < 1 ? null : context.variables().find(context.scope(), key.substring(0, index));
        return variable != null && variable.read() instanceof Value.Items list ? list : null;
    }

    /** An index that is no number counts as 0. */
    private static Value item(Value.Items list, String key) throws Failure {
        String written = key.substring(key.lastIndexOf(INDEX) + INDEX.length());
        int index = written.matches("-?\\d{1,9}") ? Integer.parseInt(written) : 0;
        if (index < 0 || index >= list.items().size()) {
            throw Failure.of("Index out of range");
        }
        return list.items().get(index);
    }

    private Variable known(String key, Failure rest) throws Failure {
        Variable variable = context.variables().find(context.scope(), key);
        if (variable == null) {
            throw rest.after("Unknown identifier: " + context.variables().wantedName(context.scope(), key));
        }
        return variable;
    }

    private static Value suffixed(Variable variable, String suffix) throws Failure {
        return switch (suffix) {
            case "" -> variable.read();
            case "'n" -> Value.of(variable.normalized());
            case "'" -> Value.of(variable.profile().speed());
            case "''" -> Value.of(variable.profile().acceleration());
            case "'d" -> Value.of(variable.measured().speed());
            case "'dd" -> Value.of(variable.measured().acceleration());
            case "'e" -> Value.of(variable.target().number() - variable.read().number());
            default -> throw Failure.inExpression();
        };
    }
}
