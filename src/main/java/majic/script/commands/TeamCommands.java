package majic.script.commands;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.run.SessionState;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Owner;
import org.jspecify.annotations.Nullable;

/** The commands for the team as a whole: the robots in it, and STOP. */
public final class TeamCommands {
    private TeamCommands() {}

    /** Connects to a robot and adds it to the team. */
    public record Add(Literal address, OptionalInt number) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE_IN_ORDER;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }

        @Override
        public void check(Check check) {
            checkAddress(address, check.session().factory());
            address.at().check(() -> check.session().connector().checkRoom(address.unquoted(), number));
        }

        @Override
        public void run(Execution execution) {
            Member member = execution.session().connector().add(address.unquoted(), number);
            if (execution.isScript()) {
                execution.claim(List.of(member));
            }
        }
    }

    /** Stops robots, closes them and removes them from the team. */
    record Remove(Robots robots) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }

        @Override
        public void check(Check check) {
            check.selection().members(robots);
        }

        @Override
        public void run(Execution execution) {
            List<Member> members = execution.selection().members(robots);
            if (!execution.isTyped()) {
                execution.awaitFinished(members);
            }
            members.forEach(execution.session().connector()::remove);
        }
    }

    /**
     * Names a robot; {@code off} takes the name away, and without a word it is asked for. Takes effect at once,
     * whatever the robot does.
     */
    public record Name(Token at, @Nullable Token name) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }

        @Override
        public String text() {
            return name == null ? "name" : "name " + name.text();
        }

        /** A word that is a type or a command of a robot would be ambiguous in front of a line. */
        @Override
        public void check(Check check) {
            if (name == null || name.is("off")) {
                return;
            }
            SessionState session = check.session();
            if (session.factory().types().stream().map(BotType::name).anyMatch(name::is)) {
                throw refused("a type of robot");
            }
            boolean isCommand = session.team().members().stream()
                    .flatMap(member -> member.bot().commands().stream())
                    .map(BotCommand::name)
                    .anyMatch(name::is);
            if (isCommand) {
                throw refused("a command of a robot");
            }
        }

        private ScriptException refused(String what) {
            Token word = Objects.requireNonNull(name);
            return new ScriptException(word, word.text() + ": " + what + " cannot be a name; take another word");
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            if (name == null) {
                robots.forEach(robot -> execution.answer(
                        robot.number() + " name" + (robot.name().isEmpty() ? ": none" : " = " + robot.name())));
                return;
            }
            String given = name.is("off") ? "" : name.text();
            if (robots.size() > 1 && !given.isEmpty()) {
                throw new ScriptException(name, given + ": each robot has a name of its own; name one robot at a time");
            }
            for (Member robot : robots) {
                name.check(() -> execution.session().team().rename(robot, given));
                execution.answer(robot.number() + " " + text() + ": done");
            }
        }

        @Override
        public String replayText(Execution execution) {
            return name == null ? "" : text();
        }
    }

    /** Lists the robots and their states. */
    record Bots() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public void run(Execution execution) {
            lines(execution.session()).forEach(execution::answer);
        }

        private static List<String> lines(SessionState session) {
            List<String> lines = new ArrayList<>();
            for (Member member : session.team().members()) {
                String where = session.connector()
                        .address(member)
                        .map(address -> " at " + address)
                        .orElse("");
                lines.add(member.number() + ": " + member.label() + where + " " + state(member));
            }
            if (lines.isEmpty()) {
                lines.add("bots: " + session.team().listing());
            }
            if (session.team().isLatched()) {
                lines.add("bots: " + session.team().latchText());
            }
            return lines;
        }

        private static String state(Member member) {
            MajicBot bot = member.bot();
            if (!bot.isConnected()) {
                return bot.connection() == MajicBot.Connection.LOST
                        ? "connection lost"
                        : bot.connection().name().toLowerCase(Locale.ROOT);
            }
            return "connected, " + doing(member);
        }

        private static String doing(Member member) {
            Owner owner = member.owner();
            if (owner != null) {
                return owner.occupationWithValues() + (owner.status().isEmpty() ? "" : ": " + owner.status());
            }
            return member.isIdle() ? "idle" : "busy";
        }
    }

    /** Reports what answers at an address. */
    record Probe(Literal address) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public void check(Check check) {
            checkAddress(address, check.session().factory());
        }

        @Override
        public void run(Execution execution) {
            SessionState session = execution.session();
            String where = address.unquoted();
            try {
                execution.answer("probe " + where + ": " + session.factory().probe(where));
            } catch (BotException e) {
                throw session.connector().explained(where, e);
            }
        }
    }

    /** Allows motion again after STOP. */
    record Release() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public void run(Execution execution) {
            execution.session().team().release();
        }
    }

    /** STOP: stops all robots and latches. */
    record StopAll() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.STOP;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }

        @Override
        public void run(Execution execution) {
            execution.stopEverything();
        }
    }

    private static void checkAddress(Literal literal, BotFactory factory) {
        literal.at().check(() -> {
            BotAddress address = factory.parse(literal.unquoted());
            if (!address.scheme().equals(BotAddress.SIMULATED)) {
                factory.type(address.type());
            }
        });
    }
}
