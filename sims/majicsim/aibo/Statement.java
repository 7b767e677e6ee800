package majicsim.aibo;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command of the language, as the parser understood it. */
sealed interface Statement {
    /** A new run of this command; nothing happens before its first step. */
    Task start(Context context);

    /** Nothing, as between two semicolons. */
    record Empty() implements Statement {
        @Override
        public Task start(Context context) {
            return Task.done(context);
        }
    }

    /** A command with its tag ({@code notag} if it has none) and flags. */
    record Tagged(String tag, List<Flag> flags, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return new TaggedTask(context.inner(tag), flags, body);
        }
    }

    /** {@code { … }}. */
    record Block(List<Step> steps) implements Statement {
        @Override
        public Task start(Context context) {
            return new CommandStream(context, steps);
        }
    }

    /** {@code a & b}. */
    record Both(Statement left, Statement right) implements Statement {
        @Override
        public Task start(Context context) {
            return new BothTask(context, left, right);
        }
    }

    /** {@code a | b}. */
    record Then(Statement left, Statement right) implements Statement {
        @Override
        public Task start(Context context) {
            return new ThenTask(context, left, right);
        }
    }

    /** An expression, whose value is the reply. */
    record Evaluate(Expr expr) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(expr), values -> Effects.reply(context, values.get(0)));
        }
    }

    /** An assignment with its modifiers. */
    record Assign(Name target, Expr value, List<Modifier> modifiers, boolean declares) implements Statement {
        @Override
        public Task start(Context context) {
            return Assigning.start(context, this);
        }
    }

    /** {@code x += v}, {@code x -= v}, {@code x++}, {@code x--}: sign is 1 or -1. */
    record Change(Name target, int sign, Expr amount) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(amount), values -> Effects.change(context, this, values.get(0)));
        }
    }

    /** {@code x->rangemin = v}. */
    record AssignProperty(Name target, String property, Expr value) implements Statement {
        @Override
        public Task start(Context context) {
            return Properties.assigning(context, this);
        }
    }

    /** {@code x = bin 5 wav;}, whose bytes follow the command; it can run only when they are filled in. */
    record AssignBinary(Name target, int size, String parameters) implements Statement {
        Statement filled(String bytes) {
            return new Assign(target, new Expr.Constant(new Value.Binary(bytes, parameters)), List.of(), false);
        }

        @Override
        public Task start(Context context) {
            return Task.done(context);
        }
    }

    /** {@code var x}. */
    record Declare(Name target) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.declare(context, target));
        }
    }

    /** {@code dev on}, {@code dev off}, {@code dev switch} (null). */
    record Power(Name device, @Nullable Double load) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.power(context, this));
        }
    }

    /** {@code if}. */
    record If(Expr test, Statement then, @Nullable Statement otherwise) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(test), values -> Effects.choose(context, this, values.get(0)));
        }
    }

    /** {@code while}, and {@code for} without its first and with its last part. */
    record While(Expr test, Statement body, @Nullable Statement step) implements Statement {
        @Override
        public Task start(Context context) {
            return new LoopTask(context, this);
        }
    }

    /** {@code loopn} with a count, {@code loop} without. */
    record Loop(@Nullable Expr times, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return CountedLoop.start(context, this);
        }
    }

    /** {@code foreach x in list}. */
    record Foreach(String variable, Expr list, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(list), values -> new ForeachTask(context, this, values.get(0)));
        }
    }

    /** {@code every (ms)}. */
    record Every(Expr periodMs, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(periodMs), values -> new EveryTask(context, body, values.get(0)));
        }
    }

    /** {@code wait}. */
    record Wait(Expr ms) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(ms), values -> new PauseTask(context, values.get(0)));
        }
    }

    /** {@code waituntil}. */
    record WaitUntil(Expr test) implements Statement {
        @Override
        public Task start(Context context) {
            return new WaitUntilTask(context, test);
        }
    }

    /** {@code timeout}, {@code stopif} and {@code freezeif}. */
    record Watched(String word, Expr limit, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return WatchedTask.start(context, this);
        }
    }

    /** {@code at}. */
    record At(Expr test, Statement body, @Nullable Statement onLeave) implements Statement {
        @Override
        public Task start(Context context) {
            return new AtTask(context, this);
        }
    }

    /** {@code whenever}. */
    record Whenever(Expr test, Statement body, @Nullable Statement otherwise) implements Statement {
        @Override
        public Task start(Context context) {
            return new WheneverTask(context, this);
        }
    }

    /** A function's definition. */
    record Define(Name function, List<String> parameters, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.define(context, this));
        }
    }

    /** {@code return}. */
    record Return(@Nullable Expr value) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(
                    context, value == null ? List.of() : List.of(value), values -> Effects.giveBack(context, values));
        }
    }

    /** {@code undef x}. */
    record Undefine(Name name) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.undefine(context, name));
        }
    }

    /** {@code group g {a, b}}, {@code addgroup}, {@code delgroup}. */
    record Grouping(String word, String group, List<String> members) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.group(context, this));
        }
    }

    /** {@code stop}, {@code freeze}, {@code unfreeze}, {@code block}, {@code unblock} with a tag. */
    record Control(String word, String tag) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> TagControl.apply(context, this));
        }
    }

    /** {@code echo}. */
    record Echo(Expr value, List<Modifier> options) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(value), values -> Effects.echo(context, values.get(0), options));
        }
    }

    /** {@code alias a b}, and {@code unalias a} (null). */
    record Alias(String name, @Nullable String meaning) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.alias(context, this));
        }
    }

    /** A command of one word, such as {@code ping}. */
    record Command(String word) implements Statement {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> SystemCommands.run(context, word));
        }
    }
}
