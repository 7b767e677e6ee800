package majicsim.aibo.urbi;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What the commands that define names do (URBI sheet, section 10); each gives the task that goes on, or null. */
final class Definitions {
    private Definitions() {}

    static @Nullable Task declare(Context context, Name name) throws Failure {
        if (context.frame() != null && name.text().indexOf('.') < 0) {
            context.kernel().variables().declare(context, name.text(), Value.VOID);
        } else {
            context.kernel().variables().target(context, name, true);
        }
        return null;
    }

    static @Nullable Task function(Context context, Definition.Define definition) throws Failure {
        context.kernel().functions().define(context, definition);
        return null;
    }

    /** An event without parameters is a variable without a value too, which hides it from a test of its bare name. */
    static @Nullable Task event(Context context, Definition.Event event) throws Failure {
        Budget.checkNames(context.kernel().events().count());
        context.kernel().events().declare(fullName(context, event.name()));
        return event.hasParameters() ? null : declare(context, event.name());
    }

    static @Nullable Task classOf(Context context, Definition.ClassOf definition) throws Failure {
        Kernel kernel = context.kernel();
        Budget.checkNames(kernel.objects().count());
        kernel.objects().define(definition.name());
        for (String variable : definition.variables()) {
            kernel.variables().target(context, Name.of(definition.name() + "." + variable), true);
        }
        definition.events().forEach(event -> kernel.events().declare(definition.name() + "." + event));
        return null;
    }

    static @Nullable Task alias(Context context, Definition.Alias alias) throws Failure {
        if (alias.meaning() != null) {
            Budget.checkNames(context.kernel().variables().aliases().size());
        }
        context.kernel().variables().alias(alias.name(), alias.meaning());
        return null;
    }

    static @Nullable Task group(Context context, Definition.Grouping grouping) throws Failure {
        Groups groups = context.kernel().groups();
        Budget.checkNames(groups.names().size());
        switch (grouping.word()) {
            case "addgroup" -> groups.add(grouping.group(), grouping.members());
            case "delgroup" -> groups.remove(grouping.group(), grouping.members());
            default -> groups.define(grouping.group(), grouping.members());
        }
        return null;
    }

    static @Nullable Task undefine(Context context, Name name) throws Failure {
        Kernel kernel = context.kernel();
        String key = new Evaluator(context).key(name);
        String full = fullName(context, name);
        if (kernel.functions().remove(context, name)) {
            return null;
        }
        if (kernel.variables().isSystem(full)) {
            throw Failure.of("variable " + full + " already in use or is a system var. Cannot delete.");
        }
        boolean object = kernel.objects().contains(key);
        if (object) {
            kernel.objects().remove(key);
            List.copyOf(kernel.variables().fields(key).keySet())
                    .forEach(field -> kernel.variables().remove(context, key + "." + field));
        }
        boolean event = kernel.events().isKnown(full);
        kernel.events().remove(full);
        if (!kernel.variables().remove(context, key) && !object && !event) {
            throw Failure.of("identifier " + full + " does not exist");
        }
        return null;
    }

    private static String fullName(Context context, Name name) throws Failure {
        return context.kernel().variables().fullName(context, new Evaluator(context).key(name));
    }
}
