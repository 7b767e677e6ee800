package majic.script;

import static majic.script.syntax.ScriptException.placed;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Suggestion;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Token;
import org.jspecify.annotations.Nullable;

/** Looks whether the session could do what it is told, without doing it. Throws a {@link ScriptException} if not. */
record SessionCheck(Session session, Selection selection) implements SessionCommand.Visitor<@Nullable Void> {
    @Override
    public @Nullable Void add(SessionCommand.Add add) {
        address(add.address());
        if (session.comings().isHere(text(add.address()), add.number())) {
            return null;
        }
        placed(add.address().at(), () -> session.team().checkRoom(add.number()));
        return null;
    }

    @Override
    public @Nullable Void remove(SessionCommand.Remove remove) {
        selection.members(remove.robots());
        return null;
    }

    @Override
    public @Nullable Void bots(SessionCommand.Bots bots) {
        return null;
    }

    @Override
    public @Nullable Void probe(SessionCommand.Probe probe) {
        address(probe.address());
        return null;
    }

    @Override
    public @Nullable Void acts(SessionCommand.Acts acts) {
        return null;
    }

    @Override
    public @Nullable Void trust(SessionCommand.Trust trust) {
        placed(trust.act().at(), () -> session.behaviours().acts().find(text(trust.act())));
        return null;
    }

    @Override
    public @Nullable Void trustOff(SessionCommand.TrustOff trustOff) {
        placed(trustOff.fileOrHash().at(), () -> session.behaviours().hashOf(text(trustOff.fileOrHash())));
        return null;
    }

    @Override
    public @Nullable Void release(SessionCommand.Release release) {
        return null;
    }

    @Override
    public @Nullable Void run(SessionCommand.Run run) {
        Path file = path(run.file());
        if (!Files.exists(file)) {
            throw new ScriptException(run.file().at(), run.file().text() + ": there is no such file");
        }
        if (!Files.isRegularFile(file)) {
            throw new ScriptException(run.file().at(), run.file().text() + ": not a file with a script");
        }
        return null;
    }

    @Override
    public @Nullable Void saveSession(SessionCommand.SaveSession save) {
        path(save.file());
        return null;
    }

    @Override
    public @Nullable Void saveLog(SessionCommand.SaveLog save) {
        path(save.file());
        return null;
    }

    @Override
    public @Nullable Void lab(SessionCommand.Lab lab) {
        if (session.factory().lab().isEmpty()) {
            throw new BotException("lab: no simulated lab runs here; start MAJIC with --lab");
        }
        return null;
    }

    @Override
    public @Nullable Void help(SessionCommand.Help help) {
        Token topic = help.topic();
        if (topic != null && !Help.topics().contains(topic.text().toLowerCase(Locale.ROOT))) {
            throw new ScriptException(
                    topic, topic.text() + ": no help on that" + Suggestion.didYouMean(topic.text(), Help.topics()));
        }
        return null;
    }

    @Override
    public @Nullable Void quit(SessionCommand.Quit quit) {
        return null;
    }

    @Override
    public @Nullable Void stopAll(SessionCommand.StopAll stop) {
        return null;
    }

    @Override
    public @Nullable Void await(SessionCommand.Await await) {
        return null;
    }

    @Override
    public @Nullable Void pause(SessionCommand.Pause pause) {
        return null;
    }

    private void address(Literal literal) {
        placed(literal.at(), () -> {
            BotAddress address = BotAddress.parse(text(literal));
            if (!address.scheme().equals(BotAddress.SIMULATED)) {
                session.factory().type(address.scheme());
            }
        });
    }

    /** What was written, without quotes, even if it looks like a number. */
    static String text(Literal literal) {
        return literal.at().kind() == Token.Kind.QUOTED
                        && literal.text().equals(literal.at().written())
                ? literal.at().text()
                : literal.text();
    }

    static Path path(Literal literal) {
        try {
            return Path.of(text(literal));
        } catch (InvalidPathException e) {
            throw new ScriptException(literal.at(), literal.text() + ": no file can have that name");
        }
    }
}
