package majicsim.aibo.urbi.command;

import java.util.List;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.run.CallTask;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Definition;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * {@code c = new C(…)}: the object inherits from the other, then its constructor {@code init} runs (URBI sheet, section
 * 10).
 */
final class Creation extends Task {
    private final String object;
    private final CallTask constructor;

    private Creation(Context context, String object, CallTask constructor) {
        super(context);
        this.object = object;
        this.constructor = constructor;
    }

    /** Makes the object; gives its constructor's run, or null if there is none to call. */
    static @Nullable Task start(Context context, Definition.New creation, List<Value> arguments) throws Failure {
        Memory memory = context.memory();
        String object = new Evaluator(context).key(creation.object());
        memory.objects().inherit(object, creation.parent());
        Name init = Name.of(object + ".init");
        boolean calls = context.functions().takesTime(context, init) || !arguments.isEmpty();
        if (!creation.constructs() || !calls) {
            return null;
        }
        List<Expr> constants = arguments.stream().<Expr>map(Expr.Constant::new).toList();
        try {
            return new Creation(
                    context, object, CallTask.of(context, new Expr.Call(init, constants), new Evaluator(context)));
        } catch (Failure failure) {
            context.report(failure);
            fail(context, object);
            return null;
        }
    }

    @Override
    protected boolean advance() {
        if (!constructor.step()) {
            return false;
        }
        if (constructor.result().isTrue()) {
            fail(context, object);
        }
        return true;
    }

    private static void fail(Context context, String object) {
        context.info("Error: Constructor failed, objet deleted");
        context.memory().objects().remove(object);
    }

    @Override
    public List<Task> parts() {
        return List.of(constructor);
    }
}
