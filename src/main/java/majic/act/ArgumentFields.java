package majic.act;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/** Finds, reads and sets the fields of an act that are marked with {@link Argument}. */
final class ArgumentFields {
    private ArgumentFields() {}

    /**
     * Returns the arguments of an act, with the present values of its fields as defaults.
     *
     * @return in the order of the fields, those of a superclass first
     * @throws ActException if a field cannot be an argument; the message gives the reason
     */
    static List<ActArgument> of(Object act) {
        List<ActArgument> arguments = new ArrayList<>();
        for (Field field : fields(act)) {
            ActArgument argument = argument(field, act);
            if (arguments.stream().anyMatch(other -> other.isNamed(argument.name()))) {
                throw new ActException("there are two arguments named " + argument.name());
            }
            arguments.add(argument);
        }
        if (arguments.size() > ActArgument.MOST) {
            throw new ActException("there are more than " + ActArgument.MOST + " arguments");
        }
        return List.copyOf(arguments);
    }

    private static List<Field> fields(Object act) {
        List<Class<?>> lineage = new ArrayList<>();
        for (Class<?> type = act.getClass(); type != null && type != Thread.class; type = type.getSuperclass()) {
            lineage.add(type);
        }
        Collections.reverse(lineage);
        return lineage.stream()
                .flatMap(type -> List.of(type.getDeclaredFields()).stream())
                .filter(field -> field.isAnnotationPresent(Argument.class))
                .toList();
    }

    private static ActArgument argument(Field field, Object act) {
        int kind = field.getModifiers();
        if (Modifier.isStatic(kind) || Modifier.isFinal(kind) || Modifier.isTransient(kind)) {
            throw unfit(field, "is static, final or transient, so it cannot be set", null);
        }
        Argument described = field.getAnnotation(Argument.class);
        try {
            field.setAccessible(true);
            return described(field.getName(), described, field.get(act));
        } catch (IllegalArgumentException | IllegalAccessException e) {
            throw unfit(field, "cannot be an argument: " + e.getMessage(), e);
        }
    }

    private static ActException unfit(Field field, String why, @Nullable Throwable cause) {
        String message = "the field '" + field.getName() + "' " + why;
        return cause == null ? new ActException(message) : new ActException(message, cause);
    }

    private static ActArgument described(String name, Argument said, Object initial) {
        String help = said.value();
        if (initial instanceof Double number) {
            return new ActArgument(
                    Parameter.number(name, said.unit(), help).within(said.from(), said.to()),
                    Value.of(number, said.unit()));
        }
        if (initial instanceof Integer number) {
            return new ActArgument(
                    Parameter.number(name, said.unit(), help)
                            .within(said.from(), said.to())
                            .inWholes(),
                    Value.of(number, said.unit()));
        }
        if (initial instanceof Boolean yes) {
            return new ActArgument(Parameter.yesNo(name, help), Value.yesNo(yes));
        }
        if (initial instanceof String text) {
            List<String> choices = List.of(said.choices());
            Parameter parameter =
                    choices.isEmpty() ? Parameter.text(name, help) : Parameter.choice(name, choices, help);
            return new ActArgument(parameter, Value.text(text));
        }
        throw new IllegalArgumentException("it is a double, an int, a boolean or a String, and not null");
    }

    /**
     * Sets the field of an argument.
     *
     * @throws ActException if the act has no such argument, or its field cannot be set
     * @throws ParameterException if the value is not permitted
     */
    static void set(Object act, String name, Value value) {
        Field field = fields(act).stream()
                .filter(one -> one.getName().equalsIgnoreCase(name))
                .findFirst()
                .orElseThrow(() -> new ActException(ActArgument.unknown(name, of(act))));
        Value fit = argument(field, act).parameter().fit(value);
        try {
            field.set(act, inJava(field.get(act), fit));
        } catch (IllegalArgumentException | IllegalAccessException e) {
            throw unfit(field, "cannot be set: " + e.getMessage(), e);
        }
    }

    private static Object inJava(Object present, Value value) {
        if (present instanceof Integer) {
            return (int) value.number();
        }
        if (present instanceof Double) {
            return value.number();
        }
        return present instanceof Boolean ? (Object) value.isYes() : value.toString();
    }
}
