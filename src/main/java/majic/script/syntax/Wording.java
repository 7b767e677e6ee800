package majic.script.syntax;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** How answers repeat a command: without its robots, in lower-case words, numbers as they were written. */
public final class Wording implements Command.Visitor<String> {
    private static final Wording INSTANCE = new Wording();

    private Wording() {}

    public static String of(Command command) {
        return command.accept(INSTANCE);
    }

    static String of(Robots robots) {
        return robots.items().stream().map(item -> item.at().text()).collect(Collectors.joining(","));
    }

    @Override
    public String move(Command.Move move) {
        return "move " + move.distance().text() + until(move.until());
    }

    @Override
    public String turn(Command.Turn turn) {
        return "turn " + turn.angle().text() + until(turn.until());
    }

    @Override
    public String drive(Command.Drive drive) {
        String speeds = "drive " + drive.speed().text() + " " + drive.rate().text();
        return drive.seconds().isPresent()
                ? speeds + " for " + seconds(drive.seconds().getAsDouble()) + "s"
                : speeds + until(drive.until());
    }

    @Override
    public String stop(Command.Stop stop) {
        return "stop";
    }

    @Override
    public String get(Command.Get get) {
        return "get " + (get.now() ? "now " : "") + names(get.parameters());
    }

    @Override
    public String set(Command.Set set) {
        return "set " + set.parameter().text() + values(set.values());
    }

    @Override
    public String log(Command.Log log) {
        return "log " + names(log.parameters()) + " every " + log.period().text();
    }

    @Override
    public String logOff(Command.LogOff logOff) {
        return "log off";
    }

    @Override
    public String act(Command.Act act) {
        Robots others = act.others();
        return "act " + act.name().text() + (others == null ? "" : " with " + of(others));
    }

    @Override
    public String actOff(Command.ActOff actOff) {
        return "act off";
    }

    @Override
    public String await(Command.Await await) {
        return "wait";
    }

    @Override
    public String help(Command.Help help) {
        Token parameter = help.parameter();
        return parameter == null ? "help" : "help " + parameter.text();
    }

    @Override
    public String own(Command.Own own) {
        return own.at().text().toLowerCase(Locale.ROOT) + values(own.arguments());
    }

    /** In full, as a rounded time would drive further. */
    private static String seconds(double seconds) {
        return BigDecimal.valueOf(seconds).stripTrailingZeros().toPlainString();
    }

    private static String until(@Nullable Condition condition) {
        return condition == null ? "" : " until " + condition;
    }

    private static String names(List<Token> parameters) {
        return parameters.stream().map(Token::text).collect(Collectors.joining(","));
    }

    private static String values(List<Literal> values) {
        return values.stream().map(value -> " " + value.text()).collect(Collectors.joining());
    }
}
