package majic.script;

import java.util.Arrays;
import java.util.List;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Wording;
import majic.team.Member;
import majic.team.Order;

/** Makes the orders that stand behind a command, one for each robot. */
final class Orders {
    /** How long a drive takes when nothing is said, seconds. */
    private static final double DRIVE_S = 1;

    /** How long a drive lasts at most whose condition does not come true, seconds: the most a robot accepts. */
    private static final double LONGEST_DRIVE_S = 60;

    private final Session session;
    private final Selection selection;

    Orders(Session session, Selection selection) {
        this.session = session;
        this.selection = selection;
    }

    Order move(Command.Move move, Member member) {
        Guard until = Until.of(move.until(), selection, member);
        double mm = move.distance().value().number();
        return motion(move, robot -> robot.move(mm, until).toString());
    }

    Order turn(Command.Turn turn, Member member) {
        Guard until = Until.of(turn.until(), selection, member);
        double degrees = turn.angle().value().number();
        return motion(turn, robot -> robot.turn(degrees, until).toString());
    }

    Order drive(Command.Drive drive, Member member) {
        Guard until = Until.of(drive.until(), selection, member);
        double speed = drive.speed().value().number();
        double rate = drive.rate().value().number();
        double seconds = drive.seconds().orElse(drive.until() == null ? DRIVE_S : LONGEST_DRIVE_S);
        return motion(drive, robot -> robot.drive(speed, rate, seconds, until).toString());
    }

    /** What a motion answers between the brackets. */
    private interface Moving {
        String report(BotControl robot);
    }

    private static Order motion(Command command, Moving moving) {
        String text = Wording.of(command);
        return new Order(text, true, robot -> List.of(text + ": done (" + moving.report(robot) + ")"));
    }

    Order get(Command.Get get, Member member) {
        List<String> names = names(get.parameters(), member.bot());
        return new Order(
                Wording.of(get),
                false,
                robot -> names.stream()
                        .map(name -> name + " = " + robot.get(name))
                        .toList());
    }

    Order set(Command.Set set, Member member) {
        String text = Wording.of(set);
        Parameter parameter = member.bot().parameter(set.parameter().text());
        List<Value> values = set.values().stream().map(Literal::value).toList();
        return new Order(text, parameter.moves(), robot -> {
            robot.set(parameter.name(), values);
            return List.of(text + ": done");
        });
    }

    Order own(Command.Own own, Member member) {
        String text = Wording.of(own);
        List<Value> values = own.arguments().stream().map(Literal::value).toList();
        boolean moves = member.bot().commands().stream()
                .filter(command -> command.name().equalsIgnoreCase(own.at().text()))
                .anyMatch(command -> command.moves());
        return new Order(text, moves, robot -> answers(text, robot.run(own.at().text(), values)));
    }

    private static List<String> answers(String text, String said) {
        return said.isBlank()
                ? List.of(text + ": done")
                : Arrays.stream(said.strip().split("\\R"))
                        .map(line -> text + ": " + line)
                        .toList();
    }

    Order log(Command.Log log, Member member) {
        String text = Wording.of(log);
        List<String> names = names(log.parameters(), member.bot());
        double seconds = log.period().value().number();
        return new Order(text, false, robot -> {
            session.sampling().start(member, names, seconds);
            return List.of(text + ": done");
        });
    }

    Order logOff(Command.LogOff logOff, Member member) {
        return new Order("log off", false, robot -> {
            session.sampling().stop(member);
            return List.of("log off: done");
        });
    }

    /** Whether an order begins or ends logging. */
    static boolean isLogging(Order order) {
        return order.text().startsWith("log ");
    }

    private static List<String> names(List<Token> parameters, MajicBot bot) {
        return parameters.stream().map(name -> name(name, bot)).toList();
    }

    private static String name(Token parameter, MajicBot bot) {
        return ScriptException.placed(
                parameter, () -> bot.parameter(parameter.text()).name());
    }
}
