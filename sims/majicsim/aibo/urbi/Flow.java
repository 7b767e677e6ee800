package majicsim.aibo.urbi;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Control flow and event handlers (URBI sheet, section 8). */
sealed interface Flow extends Statement {
    /** {@code if}. */
    record If(Expr test, Statement then, @Nullable Statement otherwise) implements Flow {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(test), values -> Effects.choose(context, this, values.get(0)));
        }
    }

    /** {@code while}, and {@code for} without its first and with its last part. */
    record While(Expr test, Statement body, @Nullable Statement step) implements Flow {
        @Override
        public Task start(Context context) {
            return new LoopTask(context, this);
        }
    }

    /** {@code loopn} with a count, {@code loop} without. */
    record Loop(@Nullable Expr times, Statement body) implements Flow {
        @Override
        public Task start(Context context) {
            return CountedLoop.start(context, this);
        }
    }

    /** {@code foreach x in list}. */
    record Foreach(String variable, Expr list, Statement body) implements Flow {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(list), values -> new ForeachTask(context, this, values.get(0)));
        }
    }

    /** {@code every (ms)}. */
    record Every(Expr periodMs, Statement body) implements Flow {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(periodMs), values -> new EveryTask(context, body, values.get(0)));
        }
    }

    /** {@code wait}. */
    record Wait(Expr ms) implements Flow {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(ms), values -> PauseTask.of(context, values.get(0)));
        }
    }

    /** {@code waituntil}. */
    record WaitUntil(Expr test) implements Flow {
        @Override
        public Task start(Context context) {
            return new WaitUntilTask(context, test);
        }
    }

    /** {@code timeout}, {@code stopif} and {@code freezeif}. */
    record Watched(String word, Expr limit, Statement body) implements Flow {
        @Override
        public Task start(Context context) {
            return WatchedTask.start(context, this);
        }
    }

    /** {@code at}. */
    record At(Expr test, Statement body, @Nullable Statement onLeave) implements Flow {
        @Override
        public Task start(Context context) {
            return new AtTask(context, this);
        }
    }

    /** {@code whenever}. */
    record Whenever(Expr test, Statement body, @Nullable Statement otherwise) implements Flow {
        @Override
        public Task start(Context context) {
            return new WheneverTask(context, this);
        }
    }

    /** {@code return}. */
    record Return(@Nullable Expr value) implements Flow {
        @Override
        public Task start(Context context) {
            return new Prepared(
                    context, value == null ? List.of() : List.of(value), values -> Effects.giveBack(context, values));
        }
    }

    /** {@code emit e(…)}, or {@code emit(ms) e(…)} for an event that lasts. */
    record Emit(Name event, List<Expr> arguments, @Nullable Expr durationMs) implements Flow {
        @Override
        public Task start(Context context) {
            List<Expr> exprs = new ArrayList<>(arguments);
            if (durationMs != null) {
                exprs.add(durationMs);
            }
            return new Prepared(context, exprs, values -> Effects.emit(context, this, values));
        }
    }
}
