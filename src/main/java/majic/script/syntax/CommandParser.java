package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import majic.script.syntax.Token.Kind;
import org.jspecify.annotations.Nullable;

/** The rules for what comes behind a robot, in both forms: {@code move 500} and {@code .move(500)}. */
public final class CommandParser {
    /** The words of the commands that every robot has. */
    public static final List<String> WORDS =
            List.of("act", "drive", "get", "help", "log", "move", "set", "stop", "turn", "wait");

    private final Cursor at;
    private final ConditionParser conditions;
    private boolean inCall;

    CommandParser(Cursor at) {
        this.at = at;
        this.conditions = new ConditionParser(at);
    }

    /** {@code call = "." WORD "(" arguments ")" ;} with the arguments of that command. */
    Command call() {
        at.advance();
        Token word = at.consume(Kind.WORD, "a command");
        at.consume(Kind.LEFT, "\"(\"");
        inCall = true;
        Command command = arguments(word);
        inCall = false;
        at.consume(Kind.RIGHT, "\")\"");
        return command;
    }

    /** {@code command = move | turn | drive | stop | get | set | log | act | wait | help | own ;} */
    Command command() {
        return arguments(at.consume(Kind.WORD, "a command"));
    }

    private Command arguments(Token word) {
        return switch (word.text().toLowerCase(Locale.ROOT)) {
            case "move" -> move(word);
            case "turn" -> turn(word);
            case "drive" -> drive(word);
            case "stop" -> new Command.Stop(word);
            case "get" -> get(word);
            case "set" -> set(word);
            case "log" -> log(word);
            case "act" -> act(word);
            case "wait" -> new Command.Await(word);
            case "help" -> help(word);
            default -> own(word);
        };
    }

    /** {@code move = "move" DISTANCE [ until ] ;} */
    private Command move(Token word) {
        return new Command.Move(word, at.number(Quantity.DISTANCE), until());
    }

    /** {@code turn = "turn" ANGLE [ until ] ;} */
    private Command turn(Token word) {
        return new Command.Turn(word, at.number(Quantity.ANGLE), until());
    }

    /** {@code drive = "drive" SPEED TURNRATE [ "for" TIME | until ] ;} */
    private Command drive(Token word) {
        Literal speed = at.number(Quantity.SPEED);
        separator();
        Literal rate = at.number(Quantity.TURN_RATE);
        separator();
        OptionalDouble seconds = at.match("for")
                ? OptionalDouble.of(at.number(Quantity.TIME).value().number())
                : OptionalDouble.empty();
        return new Command.Drive(word, speed, rate, seconds, seconds.isPresent() ? null : until());
    }

    /** {@code until = "until" condition ;} */
    private @Nullable Condition until() {
        separator();
        return at.match("until") ? conditions.condition() : null;
    }

    /** {@code get = "get" [ "now" ] parameters ;} */
    private Command get(Token word) {
        boolean now = at.match("now");
        return new Command.Get(word, parameters(), now);
    }

    /** {@code parameters = PARAMETER { "," PARAMETER } ;} */
    private List<Token> parameters() {
        List<Token> names = new ArrayList<>();
        do {
            names.add(at.consume(Kind.WORD, "a parameter"));
        } while (at.match(Kind.COMMA));
        return names;
    }

    /** {@code set = "set" PARAMETER value { value } ;} */
    private Command set(Token word) {
        Token parameter = at.consume(Kind.WORD, "a parameter");
        separator();
        List<Literal> values = new ArrayList<>();
        values.add(at.value("a value", inCall));
        values.addAll(values());
        return new Command.Set(word, parameter, values);
    }

    /** {@code log = "log" ( "off" | parameters "every" TIME ) ;} */
    private Command log(Token word) {
        if (at.match("off")) {
            return new Command.LogOff(word);
        }
        List<Token> names = parameters();
        separator();
        if (!at.match("every")) {
            throw at.unexpected("\"every\" and a time");
        }
        return new Command.Log(word, names, at.number(Quantity.TIME));
    }

    /** {@code act = "act" ( "off" | NAME [ "with" robots ] ) ;} */
    private Command act(Token word) {
        if (at.match("off")) {
            return new Command.ActOff(word);
        }
        Literal name = at.value("a behaviour's name", inCall);
        return new Command.Act(word, name, at.match("with") ? new RobotsParser(at).robots() : null);
    }

    /** {@code help = "help" [ PARAMETER ] ;} */
    private Command help(Token word) {
        return new Command.Help(word, at.check(Kind.WORD) ? at.advance() : null);
    }

    /** {@code own = WORD { value } ;} */
    private Command own(Token word) {
        return new Command.Own(word, values());
    }

    /** {@code value = NUMBER | WORD | QUOTED | TOGETHER ;} */
    private List<Literal> values() {
        List<Literal> values = new ArrayList<>();
        separator();
        while (!at.peek().isEnd() && !(inCall && at.check(Kind.RIGHT))) {
            values.add(at.value("a value", inCall));
            separator();
        }
        return values;
    }

    private void separator() {
        if (inCall) {
            at.match(Kind.COMMA);
        }
    }
}
