package majic.script.commands;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import majic.bot.Value;
import majic.script.run.SessionCommand;
import majic.script.syntax.Cursor;
import majic.script.syntax.Literal;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Operand;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;

/** The rules for commands that are for the session and not for a robot. */
public final class SessionParser {
    /** The words these commands begin with. */
    public static final List<String> WORDS = Help.SESSION_WORDS;

    private final Cursor at;

    SessionParser(Cursor at) {
        this.at = at;
    }

    /**
     * {@code sessionCommand = add | remove | probe | run | save | acts | trust | map | help | stop | wait | let | print
     * | ask | answer | "bots" | "release" | "lab" | "quit" ;}
     */
    SessionCommand sessionCommand() {
        Token word = at.advance();
        return switch (word.text().toLowerCase(Locale.ROOT)) {
            case "add" -> add();
            case "remove" -> new TeamCommands.Remove(Robots.parse(at));
            case "probe" -> new TeamCommands.Probe(address());
            case "run" -> new FileCommands.Run(file());
            case "save" -> save();
            case "trust" -> trust();
            case "acts" -> acts();
            case "map" -> map();
            case "help" -> help();
            case "stop" -> stop();
            case "wait" -> await();
            case "bots" -> new TeamCommands.Bots();
            case "release" -> new TeamCommands.Release();
            case "lab" -> new LabCommands.Lab();
            case "quit" -> new HelpCommands.Quit();
            case "let" -> let();
            case "print" -> print();
            case "ask" -> ask();
            case "answer" -> new ValueCommands.Answer(at.value("the answer", false));
            default -> throw new IllegalStateException("not in WORDS: " + word.text());
        };
    }

    /** {@code add = "add" ADDRESS [ "as" NUMBER ] ;} */
    private SessionCommand add() {
        Literal address = address();
        OptionalInt number = at.match("as") ? OptionalInt.of(at.count("a robot's number")) : OptionalInt.empty();
        return new TeamCommands.Add(address, number);
    }

    private Literal address() {
        return at.value("an address such as pioneer://10.0.0.5:8101, hemisson:COM3 or sim:aibo", false);
    }

    private Literal file() {
        return at.value("a file's name", false);
    }

    /** {@code save = "save" ( "session" | "log" | "team" ) FILE ;} */
    private SessionCommand save() {
        if (at.match("session")) {
            return new FileCommands.SaveSession(file());
        }
        if (at.match("log")) {
            return new FileCommands.SaveLog(file());
        }
        if (at.match("team")) {
            return new FileCommands.SaveTeam(file());
        }
        throw at.unexpected("\"session\", \"log\" or \"team\"");
    }

    /** {@code acts = "acts" [ ACT ] ;} */
    private SessionCommand acts() {
        return new ActCommands.Acts(at.peek().isEnd() ? null : at.value("an act's name", false));
    }

    /** {@code trust = "trust" [ ACT [ HASH ] | "off" ( ACT | HASH ) ] ;} */
    private SessionCommand trust() {
        if (at.peek().isEnd()) {
            return new ActCommands.Consents();
        }
        if (at.match("off")) {
            return new ActCommands.TrustOff(at.value("an act's name, or the hash of its file", false));
        }
        Literal act = at.value("an act's name", false);
        return new ActCommands.Trust(act, at.peek().isEnd() ? null : at.value("the hash of its file", false));
    }

    /**
     * {@code map = "map" [ "start" robots | "stop" | "open" FILE | "save" FILE | "close" | "rows" | "place" NAME (
     * "off" | "as" NAME | DISTANCE DISTANCE [ ANGLE ] ) ] ;}
     */
    private SessionCommand map() {
        if (at.peek().isEnd()) {
            return new MapCommands.Show();
        }
        Token word = at.peek();
        if (at.match("start")) {
            return new MapCommands.Start(word, Robots.parse(at));
        }
        if (at.match("stop")) {
            return new MapCommands.Stop();
        }
        if (at.match("open")) {
            return new MapCommands.Open(file());
        }
        if (at.match("save")) {
            return new FileCommands.SaveMap(file());
        }
        if (at.match("close")) {
            return new MapCommands.Close();
        }
        if (at.match("rows")) {
            return new MapCommands.Rows();
        }
        if (at.match("place")) {
            Token name = at.consume(Kind.WORD, "the name of the place");
            if (at.match("off")) {
                return new MapCommands.ChangePlace(name, null);
            }
            if (at.match("as")) {
                return new MapCommands.ChangePlace(name, at.consume(Kind.WORD, "the new name"));
            }
            Literal x = at.number(Quantity.DISTANCE);
            Literal y = at.number(Quantity.DISTANCE);
            return new MapCommands.Place(name, x, y, at.peek().isEnd() ? null : at.number(Quantity.ANGLE));
        }
        throw at.unexpected("\"start\", \"stop\", \"open\", \"save\", \"close\", \"rows\" or \"place\"");
    }

    /** {@code let = "let" NAME "=" expression ;} The name is made known only by a line that is right to its end. */
    private SessionCommand let() {
        Token name = ArgumentParser.name(at, "a name for the value");
        at.equalsSign("= and the value");
        Operand value = at.expression();
        at.endOfLine();
        at.values().declare(name, value);
        at.markOpen();
        return new ValueCommands.Let(name, value.value());
    }

    /** {@code print = "print" printed { printed } ;} */
    private SessionCommand print() {
        List<Value> values = new ArrayList<>();
        do {
            values.add(printed());
        } while (!at.peek().isEnd());
        return new ValueCommands.Print(values);
    }

    /** {@code printed = QUOTED | NUMBER | WORD | VARIABLE | "(" expression ")" ;} */
    private Value printed() {
        return at.startsComputed()
                ? at.simple().value()
                : at.value("a text in quotes, or a value", false).computable();
    }

    /** {@code ask = "ask" NAME "=" described [ "for" TIME ] ;} */
    private SessionCommand ask() {
        Token name = ArgumentParser.name(at, "a name for the answer");
        at.equalsSign("= and the answer that is taken if none comes");
        ArgumentParser.Described asked = ArgumentParser.described(at, name, initial -> {});
        Literal time = at.match("for") ? at.number(Quantity.TIME) : null;
        at.endOfLine();
        at.values().declare(name, Operand.of(asked.initial()));
        at.markOpen();
        return new ValueCommands.Ask(name, asked.parameter(), asked.initial(), time);
    }

    /** {@code help = "help" [ WORD ] ;} */
    private SessionCommand help() {
        return new HelpCommands.LanguageHelp(at.check(Kind.WORD) ? at.advance() : null);
    }

    /** {@code stop = "stop" [ "all" ] ;} */
    private SessionCommand stop() {
        at.match("all");
        return new TeamCommands.StopAll();
    }

    /** {@code wait = "wait" [ TIME ] ;} where the unit is required. */
    private SessionCommand await() {
        at.fillIn();
        if (!at.check(Kind.NUMBER)) {
            return new WaitCommands.AwaitAll();
        }
        Token number = at.peek();
        Literal time = at.number(Quantity.TIME);
        at.refuseDecimalComma();
        if (!number.open()
                && Character.isDigit(number.text().charAt(number.text().length() - 1))) {
            throw new ScriptException(
                    number, number.text() + ": the unit is required, for instance \"wait " + number.text() + "s\"");
        }
        if (time.value().number() < 0) {
            throw new ScriptException(number, number.text() + ": time does not run backward");
        }
        return new WaitCommands.Pause(time);
    }
}
