package majic.script;

import java.util.List;
import java.util.function.Function;
import majic.script.syntax.Command;
import majic.script.syntax.Robots;
import majic.team.Member;
import majic.team.Order;
import org.jspecify.annotations.Nullable;

/** Tells robots one command: most become orders in their queues. */
final class Telling implements Command.Visitor<@Nullable Void> {
    private final Execution execution;
    private final Orders orders;
    private final List<Member> members;

    Telling(Execution execution, List<Member> members) {
        this.execution = execution;
        this.orders = new Orders(execution.session(), execution.selection());
        this.members = members;
    }

    @Override
    public @Nullable Void move(Command.Move move) {
        execution.submit(members, member -> orders.move(move, member));
        return null;
    }

    @Override
    public @Nullable Void turn(Command.Turn turn) {
        execution.submit(members, member -> orders.turn(turn, member));
        return null;
    }

    @Override
    public @Nullable Void drive(Command.Drive drive) {
        execution.submit(members, member -> orders.drive(drive, member));
        return null;
    }

    @Override
    public @Nullable Void stop(Command.Stop stop) {
        execution.stop(members);
        return null;
    }

    @Override
    public @Nullable Void get(Command.Get get) {
        if (get.now() || execution.isTyped()) {
            execution.runNow(members, member -> orders.get(get, member));
        } else {
            execution.read(members, member -> orders.get(get, member));
        }
        return null;
    }

    @Override
    public @Nullable Void set(Command.Set set) {
        execution.submit(members, member -> orders.set(set, member));
        return null;
    }

    @Override
    public @Nullable Void log(Command.Log log) {
        beside(member -> orders.log(log, member));
        return null;
    }

    @Override
    public @Nullable Void logOff(Command.LogOff logOff) {
        beside(member -> orders.logOff(logOff, member));
        return null;
    }

    @Override
    public @Nullable Void act(Command.Act act) {
        Robots others = act.others();
        if (others != null) {
            execution.claim(execution.selection().members(others));
        }
        execution.submit(members, member -> behaviours().order(act, member, execution));
        return null;
    }

    private Behaviours behaviours() {
        return execution.session().behaviours();
    }

    @Override
    public @Nullable Void actOff(Command.ActOff actOff) {
        execution.runToEnd(members, member -> behaviours().callOff(member));
        return null;
    }

    @Override
    public @Nullable Void await(Command.Await await) {
        execution.awaitFinished(members);
        return null;
    }

    @Override
    public @Nullable Void help(Command.Help help) {
        members.forEach(
                member -> Help.of(member, help.parameter()).forEach(line -> execution.say(Line.Kind.ANSWER, line)));
        return null;
    }

    @Override
    public @Nullable Void own(Command.Own own) {
        execution.submit(members, member -> orders.own(own, member));
        return null;
    }

    /** What moves nothing need not wait for a motion when a person says it. */
    private void beside(Function<Member, Order> made) {
        if (execution.isTyped()) {
            execution.runNow(members, made);
        } else {
            execution.read(members, made);
        }
    }
}
