package majic.script.run;

import java.util.List;
import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.syntax.Operand;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Values;
import majic.team.Member;

/**
 * The values of the names and readings of a line that runs.
 *
 * @param execution whose names are meant, and which finds the robots
 * @param waits whether a robot finishes its commands before it is read
 */
public record LiveValues(Execution execution, boolean waits) implements Values {
    private static final double MS_IN_A_SECOND = 1000;

    /**
     * The values of a line of its own. A robot finishes its commands before it is read, unless the line was typed and
     * commands no robot: then it is read at once, as {@code get} does.
     */
    public static LiveValues ofLine(Execution execution, Statement sample) {
        return new LiveValues(execution, !execution.isTyped() || sample instanceof Statement.ForRobots);
    }

    @Override
    public Operand named(Token name) {
        Value value = execution.scope().find(name.text().substring(1));
        if (value == null) {
            throw new ScriptException(name, name.text() + ": it has no value yet");
        }
        return Operand.of(value);
    }

    @Override
    public void declare(Token name, Operand value) {
        // The command gives the name its value.
    }

    @Override
    public Operand reading(Robots robots, Token parameter) {
        Member member = Types.one(robots, execution.selection());
        return Operand.of(read(member, parameter, parameter.text()));
    }

    private Value read(Member member, Token at, String name) {
        if (waits) {
            execution.awaitReadable(List.of(member));
        }
        MajicBot bot = member.bot();
        Value value = at.resolve(() -> bot.get(bot.parameter(name).name()));
        if (value instanceof Value.Unknown) {
            throw new ScriptException(at, member.number() + " " + name + " is " + value);
        }
        if (value instanceof Value.Many) {
            throw new ScriptException(at, name + ": a list cannot be computed with; take one of its values");
        }
        return value instanceof Value.Number number && number.unit() == Unit.MS
                ? new Value.Number(number.amount() / MS_IN_A_SECOND, Unit.S, number.about())
                : value;
    }

    /** A place, with the heading of what stands there, if that is a robot. */
    private record End(Pose pose, boolean isRobot, boolean about) {}

    @Override
    public Operand between(Token function, List<Token> ends) {
        End from = end(ends.get(0));
        End to = end(ends.get(1));
        boolean about = from.about || to.about;
        double dx = to.pose.xMm() - from.pose.xMm();
        double dy = to.pose.yMm() - from.pose.yMm();
        if (function.is("distance")) {
            return Operand.of(new Value.Number(Math.hypot(dx, dy), Unit.MM, about));
        }
        double direction = Math.toDegrees(Math.atan2(dy, dx)) - (from.isRobot ? from.pose.headingDeg() : 0);
        return Operand.of(new Value.Number(Math.IEEEremainder(direction, 360), Unit.DEG, about));
    }

    private End end(Token named) {
        Optional<Pose> place = execution.session().map().whereIs(named.text());
        if (place.isPresent()) {
            return new End(place.get(), false, false);
        }
        Member member = Types.one(Robots.of(named), execution.selection());
        Value x = read(member, named, "x");
        Value y = read(member, named, "y");
        Value heading = read(member, named, "heading");
        boolean about = x instanceof Value.Number number && number.about();
        return new End(new Pose(x.number(), y.number(), heading.number()), true, about);
    }

    @Override
    public double random() {
        execution.markNotRepeatable();
        return execution.session().random().next();
    }
}
