package majic.script.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.syntax.Condition;
import majic.script.syntax.Late;
import majic.script.syntax.Mistake;
import majic.script.syntax.Operand;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Checks a script against the robots that are there, before anything of it runs. Behind a command that changes the team
 * nothing is checked, since other robots may be there by then.
 */
public final class Checker extends Inspection {
    /** Blocks and calls that are checked inside each other. */
    private static final int DEEPEST = 100;

    private final SessionState session;
    private final Selection selection;
    private final Set<Member> limitsSet = new HashSet<>();
    private final Set<List<Object>> checkedCalls = new HashSet<>();
    private final List<Procedure> defined = new ArrayList<>();
    private final Set<Procedure> called = new HashSet<>();
    private final Types types;
    private int depth;
    private final boolean readsFiles;
    private boolean teamMayChange;
    private boolean filesMayAppear;

    private Checker(SessionState session, Selection selection, Types types, boolean readsFiles) {
        this.session = session;
        this.selection = selection;
        this.readsFiles = readsFiles;
        this.types = types;
    }

    /** Everything wrong in a script, in its order. Reads the files it names, so it may block. */
    public static List<Mistake> check(List<Statement> script, SessionState session, Selection selection) {
        return check(script, new Checker(session, selection, new Types(selection), true));
    }

    /**
     * Everything wrong in a block of a prompt, in its order.
     *
     * @param names what is known of the names at the prompt
     * @param readsFiles whether the files that it names are read, which may block
     */
    public static List<Mistake> check(
            List<Statement> script,
            SessionState session,
            Selection selection,
            Scope<Operand> names,
            boolean readsFiles) {
        return check(script, new Checker(session, selection, new Types(selection, names.inner()), readsFiles));
    }

    private static List<Mistake> check(List<Statement> script, Checker checker) {
        checker.walk(script);
        checker.checkUncalled();
        return checker.mistakes().stream()
                .sorted(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column))
                .toList();
    }

    @Override
    public void inspect(Late<Condition> condition) {
        Condition known = condition.with(types);
        if (!teamMayChange) {
            Comparisons.check(known, selection, null);
        }
    }

    @Override
    void block(List<Statement> body) {
        depth++;
        types.begin();
        walk(body);
        types.end();
        depth--;
    }

    @Override
    public @Nullable Void repeat(Statement.Repeat repeat) {
        repeat.times().with(types);
        return super.repeat(repeat);
    }

    @Override
    public @Nullable Void argument(Statement.Argument argument) {
        types.argument(argument.name(), Operand.of(argument.value()));
        return null;
    }

    /** What is known of its values now shows more than when it was parsed. */
    @Override
    public @Nullable Void computed(Statement.Computed line) {
        return line.line().with(types).accept(this);
    }

    /**
     * A procedure is checked where it is called, for each kind of values. Calls further inside are left out: a chain of
     * calls may be as long as the script.
     */
    @Override
    public @Nullable Void call(Statement.Call call) {
        if (depth < DEEPEST) {
            called.add(call.procedure());
            checkBody(
                    call.procedure(), call.given().stream().map(Operand::kindOf).toList());
        }
        return null;
    }

    @Override
    public @Nullable Void procedure(Statement.ProcedureDefinition definition) {
        defined.add(definition.procedure());
        return null;
    }

    /** A procedure that is not called is checked at the end, as if it were called there. */
    private void checkUncalled() {
        for (Procedure procedure : defined) {
            if (!called.contains(procedure)) {
                checkBody(
                        procedure,
                        procedure.arguments().stream()
                                .map(argument -> Operand.ANY)
                                .toList());
            }
        }
    }

    private void checkBody(Procedure procedure, List<Operand> given) {
        if (!checkedCalls.add(List.of(procedure, given))) {
            return;
        }
        depth++;
        types.inProcedure(() -> {
            for (int index = 0; index < given.size(); index++) {
                types.argument(procedure.arguments().get(index), given.get(index));
            }
            walk(procedure.body());
        });
        depth--;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        if (!teamMayChange) {
            List<Member> robots = selection.members(line.robots());
            line.command()
                    .check(robots.stream()
                            .map(robot ->
                                    new Command.Check(session, selection, robot, limitsSet.contains(robot), readsFiles))
                            .toList());
            if (line.command().has(CommandTrait.CHANGES_LIMIT)) {
                limitsSet.addAll(robots);
            }
            mayChangeTeam(line.command().has(CommandTrait.CHANGES_TEAM));
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        if (!teamMayChange && (readsFiles || !line.command().has(CommandTrait.READS_FILES))) {
            line.command().check(new SessionCommand.Check(session, selection, filesMayAppear));
        }
        filesMayAppear |= line.command().has(CommandTrait.WRITES_FILE);
        mayChangeTeam(line.command().has(CommandTrait.CHANGES_TEAM));
        return null;
    }

    private void mayChangeTeam(boolean mayChange) {
        if (mayChange) {
            teamMayChange = true;
            types.forgetRobots();
        }
    }
}
