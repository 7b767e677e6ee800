package majic.script.run;

import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.conditions.Selection;
import majic.script.syntax.Operand;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Values;
import majic.team.Member;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * What is known of the values of a script before it runs: the units of its numbers. Without robots nothing is known of
 * a reading.
 */
public final class Types implements Values {
    /** A message lists this many names at most. */
    private static final int MOST_LISTED = 20;

    private @Nullable Selection robots;
    private Scope<Operand> scope;

    /**
     * Without names.
     *
     * @param robots finds the robots; null while it is unknown which ones are there
     */
    public Types(@Nullable Selection robots) {
        this(robots, new Scope<>());
    }

    /** With the names of a scope, to which further ones are added. */
    public Types(@Nullable Selection robots, Scope<Operand> scope) {
        this.robots = robots;
        this.scope = scope;
    }

    /** From now on other robots may be there. */
    public void forgetRobots() {
        robots = null;
    }

    /** The names that are known here. */
    public Scope<Operand> scope() {
        return scope;
    }

    /** Begins a block: the names that are new in it end with it. */
    public void begin() {
        scope = scope.inner();
    }

    /** Ends a block. */
    public void end() {
        scope = scope.around();
    }

    /** Runs a task inside a procedure, which knows the names outside of all blocks and its own ones. */
    public void inProcedure(Runnable task) {
        Scope<Operand> caller = scope;
        scope = scope.outermost().inner();
        try {
            task.run();
        } finally {
            scope = caller;
        }
    }

    /** Adds a name to the block. */
    public void argument(Token name, Operand value) {
        scope.declare(name.text(), value);
    }

    public boolean knows(String name) {
        return scope.find(name) != null;
    }

    @Override
    public Operand named(Token name) {
        String plain = name.text().substring(1);
        Operand value = scope.find(plain);
        if (value == null) {
            throw new ScriptException(name, name.text() + ": " + noSuchName(plain));
        }
        return value;
    }

    private String noSuchName(String plain) {
        List<String> known = scope.names();
        return known.isEmpty()
                ? "there is no value of that name; \"let " + plain + " = VALUE\" makes one"
                : "there is no value of that name" + Suggestion.didYouMean(plain, known) + " (there are "
                        + String.join(", ", known.subList(0, Math.min(known.size(), MOST_LISTED)))
                        + (known.size() > MOST_LISTED ? " …" : "") + ")";
    }

    @Override
    public void declare(Token name, Operand value) {
        Operand before = scope.find(name.text());
        if (before != null && !before.open()) {
            throw new ScriptException(
                    name, name.text() + ": it is an argument, which keeps its value; take another name");
        }
        if (before == null || before.any()) {
            scope.assign(name.text(), opened(value));
            return;
        }
        boolean isClear = value.value() == Value.CLEAR && before.isNumber();
        if (!value.any() && !isClear) {
            requireSameKind(name, before, value);
        }
        boolean isBare = before.isNumber() && before.unit() == Unit.NONE;
        if (isBare && !isClear) {
            scope.assign(name.text(), opened(value));
        }
    }

    /**
     * The value that a name has after {@code let} or an answer while a script runs: a number without unit takes the
     * unit of the value before.
     *
     * @param before the value that it had; null if it had none
     * @throws ScriptException if the kind of the value is another one
     */
    public static Value kept(Token name, @Nullable Value before, Value value) {
        if (before == null || before == Value.CLEAR || value == Value.CLEAR) {
            return value;
        }
        requireSameKind(name, Operand.of(before), Operand.of(value));
        return before instanceof Value.Number old && value instanceof Value.Number number && number.unit() == Unit.NONE
                ? new Value.Number(number.amount(), old.unit(), number.about())
                : value;
    }

    private static void requireSameKind(Token name, Operand before, Operand value) {
        boolean otherUnit = before.unit() != Unit.NONE && value.unit() != Unit.NONE && before.unit() != value.unit();
        if (before.isNumber() != value.isNumber() || otherUnit) {
            throw new ScriptException(
                    name,
                    name.text() + ": it is " + opened(before).kind() + " and cannot become "
                            + opened(value).kind());
        }
    }

    /** A name that may get another value later. */
    private static Operand opened(Operand value) {
        if (value.any()) {
            return value;
        }
        if (value.isNumber()) {
            return Operand.open(value.unit());
        }
        return value.value() == Value.CLEAR ? Operand.ANY : Operand.OPEN_WORD;
    }

    @Override
    public Operand reading(Robots named, Token parameter) {
        if (robots == null) {
            return Operand.ANY;
        }
        Member member = one(named, robots);
        Parameter known = parameter.resolve(() -> member.bot().parameter(parameter.text()));
        if (!known.readable()) {
            throw new ScriptException(parameter, parameter.text() + ": can be set but not read");
        }
        return switch (known.kind()) {
            case NUMBER -> Operand.open(known.unit());
            case LIST ->
                throw new ScriptException(
                        parameter, parameter.text() + ": a list cannot be computed with; take one of its values");
            case YES_NO, ON_OFF, CHOICE, TEXT -> Operand.OPEN_WORD;
        };
    }

    /** The robot of a reading. */
    static Member one(Robots named, Selection robots) {
        List<Member> members = robots.members(named);
        if (members.size() != 1) {
            throw new ScriptException(
                    named.at(), named.text() + ": a value is read from one robot; write its number in front");
        }
        return members.get(0);
    }

    @Override
    public Operand between(Token function, List<Token> ends) {
        return Operand.open(function.is("distance") ? Unit.MM : Unit.DEG);
    }

    @Override
    public double random() {
        return 0.5;
    }
}
