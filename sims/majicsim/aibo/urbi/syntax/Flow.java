package majicsim.aibo.urbi.syntax;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Control flow and event handlers (URBI sheet, section 8). */
public sealed interface Flow extends Statement {
    /**
     * One method for each kind of these commands.
     *
     * @param <R> the visitor's result
     */
    interface Visitor<R> {
        R choose(If command);

        R repeatWhile(While command);

        R loop(Loop command);

        R foreach(Foreach command);

        R every(Every command);

        R pause(Wait command);

        R waitUntil(WaitUntil command);

        R watch(Watched command);

        R at(At command);

        R whenever(Whenever command);

        R giveBack(Return command);

        R emit(Emit command);
    }

    /** {@code if}. */
    record If(Expr test, Statement then, @Nullable Statement otherwise) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.choose(this);
        }
    }

    /** {@code while}, and {@code for} without its first and with its last part. */
    record While(Expr test, Statement body, @Nullable Statement step) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.repeatWhile(this);
        }
    }

    /** {@code loopn} with a count, {@code loop} without. */
    record Loop(@Nullable Expr times, Statement body) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.loop(this);
        }
    }

    /** {@code foreach x in list}. */
    record Foreach(String variable, Expr list, Statement body) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.foreach(this);
        }
    }

    /** {@code every (ms)}. */
    record Every(Expr periodMs, Statement body) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.every(this);
        }
    }

    /** {@code wait}. */
    record Wait(Expr ms) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.pause(this);
        }
    }

    /** {@code waituntil}. */
    record WaitUntil(Expr test) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.waitUntil(this);
        }
    }

    /** {@code timeout}, {@code stopif} and {@code freezeif}. */
    record Watched(String word, Expr limit, Statement body) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.watch(this);
        }
    }

    /** {@code at}. */
    record At(Expr test, Statement body, @Nullable Statement onLeave) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.at(this);
        }
    }

    /** {@code whenever}. */
    record Whenever(Expr test, Statement body, @Nullable Statement otherwise) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.whenever(this);
        }
    }

    /** {@code return}. */
    record Return(@Nullable Expr value) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.giveBack(this);
        }
    }

    /** {@code emit e(…)}, or {@code emit(ms) e(…)} for an event that lasts. */
    record Emit(Name event, List<Expr> arguments, @Nullable Expr durationMs) implements Flow {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.emit(this);
        }
    }
}
