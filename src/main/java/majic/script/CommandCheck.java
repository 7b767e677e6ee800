package majic.script;

import static majic.script.syntax.ScriptException.placed;

import java.util.List;
import java.util.Locale;
import majic.bot.Checks;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.script.syntax.Command;
import majic.script.syntax.CommandParser;
import majic.script.syntax.Condition;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Looks whether a robot could do what it is told, without telling it. Throws a {@link ScriptException} if not. */
final class CommandCheck implements Command.Visitor<@Nullable Void> {
    private static final double SHORTEST_PERIOD_S = 0.01;
    private static final double LONGEST_PERIOD_S = 86_400;

    private final Behaviours behaviours;
    private final Selection selection;
    private final Member member;
    private final MajicBot bot;
    private final boolean limitMayChange;

    CommandCheck(Behaviours behaviours, Selection selection, Member member) {
        this(behaviours, selection, member, false);
    }

    /**
     * A check of commands for one robot.
     *
     * @param limitMayChange whether {@code maxMove} may be another one when the command's turn comes; what a robot that
     *     is busy will be told before is not known here either
     */
    CommandCheck(Behaviours behaviours, Selection selection, Member member, boolean limitMayChange) {
        this.behaviours = behaviours;
        this.limitMayChange = limitMayChange || !member.isIdle();
        this.selection = selection;
        this.member = member;
        this.bot = member.bot();
    }

    @Override
    public @Nullable Void move(Command.Move move) {
        until(move.until());
        if (!limitMayChange) {
            placed(move.distance().at(), () -> Checks.move(bot, number(move.distance())));
        }
        return null;
    }

    @Override
    public @Nullable Void turn(Command.Turn turn) {
        placed(turn.angle().at(), () -> Checks.turn(number(turn.angle())));
        return until(turn.until());
    }

    @Override
    public @Nullable Void drive(Command.Drive drive) {
        double seconds = drive.seconds().orElse(1);
        placed(drive.speed().at(), () -> Checks.drive(bot, number(drive.speed()), number(drive.rate()), seconds));
        return until(drive.until());
    }

    @Override
    public @Nullable Void stop(Command.Stop stop) {
        return null;
    }

    @Override
    public @Nullable Void get(Command.Get get) {
        get.parameters().forEach(this::readable);
        return null;
    }

    @Override
    public @Nullable Void set(Command.Set set) {
        Token at = set.values().get(0).at();
        if (!parameter(set.parameter()).writable()) {
            throw new ScriptException(set.parameter(), set.parameter().text() + ": can be read but not set");
        }
        placed(
                at,
                () -> bot.checkSet(
                        set.parameter().text(),
                        set.values().stream().map(Literal::value).toList()));
        return null;
    }

    @Override
    public @Nullable Void log(Command.Log log) {
        log.parameters().forEach(this::readable);
        double seconds = number(log.period());
        if (seconds < SHORTEST_PERIOD_S || seconds > LONGEST_PERIOD_S) {
            throw new ScriptException(
                    log.period().at(), log.period().text() + ": the log takes from 10 ms to one day between readings");
        }
        return null;
    }

    @Override
    public @Nullable Void logOff(Command.LogOff logOff) {
        return null;
    }

    @Override
    public @Nullable Void act(Command.Act act) {
        behaviours.check(act, member, selection);
        return null;
    }

    @Override
    public @Nullable Void actOff(Command.ActOff actOff) {
        return null;
    }

    @Override
    public @Nullable Void await(Command.Await await) {
        return null;
    }

    @Override
    public @Nullable Void help(Command.Help help) {
        if (help.parameter() != null && !isCommand(help.parameter().text())) {
            parameter(help.parameter());
        }
        return null;
    }

    @Override
    public @Nullable Void own(Command.Own own) {
        Token place =
                own.arguments().isEmpty() ? own.at() : own.arguments().get(0).at();
        List<Literal> arguments = own.arguments();
        if (!isCommand(own.at().text())) {
            throw new ScriptException(own.at(), Help.noSuchCommand(own.at().text(), bot));
        }
        placed(
                place,
                () -> Checks.run(
                        bot,
                        own.at().text(),
                        arguments.stream().map(Literal::value).toList()));
        return null;
    }

    private boolean isCommand(String word) {
        return CommandParser.WORDS.contains(word.toLowerCase(Locale.ROOT))
                || bot.commands().stream().anyMatch(own -> own.name().equalsIgnoreCase(word));
    }

    private @Nullable Void until(@Nullable Condition condition) {
        if (condition != null) {
            Comparing.check(condition, selection, member);
        }
        return null;
    }

    private Parameter parameter(Token name) {
        return placed(name, () -> bot.parameter(name.text()));
    }

    private void readable(Token name) {
        if (!parameter(name).readable()) {
            throw new ScriptException(name, name.text() + ": can be set but not read");
        }
    }

    private static double number(Literal literal) {
        return literal.value().number();
    }
}
