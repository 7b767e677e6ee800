package majic.script.actions;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.SessionAction;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** The commands for the team as a whole: the robots in it, and STOP. */
final class TeamActions {
    private TeamActions() {}

    static final class AddAction implements SessionAction {
        private final SessionCommand.Add add;
        private final RobotConnector connector;
        private final BotFactory factory;

        AddAction(SessionCommand.Add add, RobotConnector connector, BotFactory factory) {
            this.add = add;
            this.connector = connector;
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            checkAddress(add.address(), factory);
            add.address().at().check(() -> connector.checkRoom(add.address().unquoted(), add.number()));
        }

        @Override
        public void run(Execution execution) {
            Member member = connector.add(add.address().unquoted(), add.number());
            if (execution.isScript()) {
                execution.claim(List.of(member));
            }
        }
    }

    static final class RemoveAction implements SessionAction {
        private final Robots robots;
        private final RobotConnector connector;

        RemoveAction(SessionCommand.Remove remove, RobotConnector connector) {
            this.robots = remove.robots();
            this.connector = connector;
        }

        @Override
        public void check(Check check) {
            check.selection().members(robots);
        }

        @Override
        public void run(Execution execution) {
            List<Member> members = execution.selection().members(robots);
            if (!execution.isTyped()) {
                execution.waits().awaitFinished(members);
            }
            members.forEach(connector::remove);
        }
    }

    /** Names a robot, or answers the name. Takes effect at once, whatever the robot does. */
    static final class NameAction extends RobotAction {
        private final @Nullable Token name;
        private final Team team;
        private final BotFactory factory;

        NameAction(Command.Name command, Team team, BotFactory factory) {
            super(command);
            this.name = command.name();
            this.team = team;
            this.factory = factory;
        }

        /** A word that is a type or a command of a robot would be ambiguous in front of a line. */
        @Override
        public void check(Check check) {
            if (name == null || name.is("off")) {
                return;
            }
            if (factory.types().stream().map(BotType::name).anyMatch(name::is)) {
                throw refused("a type of robot");
            }
            boolean isCommand = team.members().stream()
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
                name.check(() -> team.rename(robot, given));
                execution.answer(robot.number() + " " + text() + ": done");
            }
        }

        @Override
        public String replayText(boolean typed) {
            return name == null ? "" : text();
        }
    }

    static final class BotsAction implements SessionAction {
        private final Team team;
        private final RobotConnector connector;

        BotsAction(Team team, RobotConnector connector) {
            this.team = team;
            this.connector = connector;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            lines().forEach(execution::answer);
        }

        /** The robots and their states. */
        private List<String> lines() {
            List<String> lines = new ArrayList<>();
            for (Member member : team.members()) {
                String where = connector
                        .address(member)
                        .map(address -> " at " + address)
                        .orElse("");
                lines.add(member.number() + ": " + member.label() + where + " " + state(member));
            }
            if (lines.isEmpty()) {
                lines.add("bots: " + team.listing());
            }
            if (team.isLatched()) {
                lines.add("bots: " + team.latchText());
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

    static final class ProbeAction implements SessionAction {
        private final Literal address;
        private final RobotConnector connector;
        private final BotFactory factory;

        ProbeAction(SessionCommand.Probe probe, RobotConnector connector, BotFactory factory) {
            this.address = probe.address();
            this.connector = connector;
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            checkAddress(address, factory);
        }

        @Override
        public void run(Execution execution) {
            String where = address.unquoted();
            try {
                execution.answer("probe " + where + ": " + factory.probe(where));
            } catch (BotException e) {
                throw connector.explained(where, e);
            }
        }
    }

    static final class ReleaseAction implements SessionAction {
        private final Team team;

        ReleaseAction(Team team) {
            this.team = team;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            team.release();
        }
    }

    /** STOP. */
    static final class StopAllAction implements SessionAction {
        @Override
        public void check(Check check) {}

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
