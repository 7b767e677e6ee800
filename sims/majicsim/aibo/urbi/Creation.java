package majicsim.aibo.urbi;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** {@code c = new C(…)}: the object inherits from the other, then its constructor {@code init} runs (URBI sheet, section 10). */
final class Creation extends Task {
    private final String object;
    private final Evaluation constructor;

    private Creation(Context context, String object, Expr.Call init) {
        super(context);
        this.object = object;
        constructor = new Evaluation(context, init);
    }

    /** Makes the object; gives its constructor's run, or null if there is none to call. */
    static @Nullable Task start(Context context, Definition.New creation, List<Value> arguments) throws Failure {
        Kernel kernel = context.kernel();
        String object = new Evaluator(context, Map.of()).key(creation.object());
        kernel.objects().inherit(object, creation.parent());
        Name init = Name.of(object + ".init");
        boolean calls = kernel.functions().takesTime(context, init) || !arguments.isEmpty();
        if (!creation.constructs() || !calls) {
            return null;
        }
        List<Expr> constants = arguments.stream().<Expr>map(Expr.Constant::new).toList();
        return new Creation(context, object, new Expr.Call(init, constants));
    }

    @Override
    protected boolean advance() {
        if (!constructor.step()) {
            return false;
        }
        if (constructor.value() == null || constructor.holds()) {
            context.info("Error: Constructor failed, objet deleted");
            context.kernel().objects().remove(object);
        }
        return true;
    }

    @Override
    protected List<Task> parts() {
        return List.of(constructor);
    }
}
