package majicsim.aibo.urbi.command;

import java.util.List;
import majicsim.aibo.urbi.memory.Groups;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Definition;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** What the commands that define names do (URBI sheet, section 10); each gives the task that goes on, or null. */
final class Definitions {
    private Definitions() {}

    static @Nullable Task declare(Context context, Name name) throws Failure {
        if (context.frame() != null && name.text().indexOf('.') < 0) {
            context.variables().declare(context.scope(), name.text(), Value.VOID);
        } else {
            new Evaluator(context).target(name, true);
        }
        return null;
    }

    static @Nullable Task function(Context context, Definition.Define definition) throws Failure {
        context.functions().define(context, definition);
        return null;
    }

    /** An event without parameters is a variable without a value too, which hides it from a test of its bare name. */
    static @Nullable Task event(Context context, Definition.Event event) throws Failure {
        MemoryLimits.checkNames(context.memory().events().count());
        context.memory().events().declare(fullName(context, event.name()));
        return event.hasParameters() ? null : declare(context, event.name());
    }

    static @Nullable Task classOf(Context context, Definition.ClassOf definition) throws Failure {
        Memory memory = context.memory();
        MemoryLimits.checkNames(memory.objects().count());
        memory.objects().define(definition.name());
        for (String variable : definition.variables()) {
            new Evaluator(context).target(Name.of(definition.name() + "." + variable), true);
        }
        definition.events().forEach(event -> memory.events().declare(definition.name() + "." + event));
        return null;
    }

    static @Nullable Task alias(Context context, Definition.Alias alias) throws Failure {
        if (alias.meaning() != null) {
            MemoryLimits.checkNames(context.variables().aliases().size());
        }
        context.variables().alias(alias.name(), alias.meaning());
        return null;
    }

    static @Nullable Task group(Context context, Definition.Grouping grouping) throws Failure {
        Groups groups = context.memory().groups();
        MemoryLimits.checkNames(groups.names().size());
        switch (grouping.word()) {
            case "addgroup" -> groups.add(grouping.group(), grouping.members());
            case "delgroup" -> groups.remove(grouping.group(), grouping.members());
            default -> groups.define(grouping.group(), grouping.members());
        }
        return null;
    }

    static @Nullable Task undefine(Context context, Name name) throws Failure {
        Memory memory = context.memory();
        String key = new Evaluator(context).key(name);
        String full = fullName(context, name);
        if (context.functions().remove(context, name)) {
            return null;
        }
        if (memory.variables().isSystem(full)) {
            throw Failure.of("variable " + full + " already in use or is a system var. Cannot delete.");
        }
        boolean object = memory.objects().contains(key);
        if (object) {
            memory.objects().remove(key);
            List.copyOf(memory.variables().fields(key).keySet())
                    .forEach(field -> memory.variables().remove(context.scope(), key + "." + field));
        }
        boolean event = memory.events().isKnown(full);
        memory.events().remove(full);
        if (!memory.variables().remove(context.scope(), key) && !object && !event) {
            throw Failure.of("identifier " + full + " does not exist");
        }
        return null;
    }

    private static String fullName(Context context, Name name) throws Failure {
        return context.variables().fullName(context.scope(), new Evaluator(context).key(name));
    }
}
