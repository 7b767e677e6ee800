package majic.script.actions;

import java.util.List;
import java.util.Locale;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionAction;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.SessionCommand;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;

/** The commands for the team as a whole: the robots in it, STOP, and the simulated lab. */
final class TeamActions {
    private TeamActions() {}

    static final class AddAction extends SessionAction {
        private final SessionCommand.Add add;
        private final RobotConnector connector;
        private final BotFactory factory;

        AddAction(SessionCommand.Add add, RobotConnector connector, BotFactory factory) {
            super(Scheduling.BESIDE_IN_ORDER, CommandTrait.CHANGES_TEAM);
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

    static final class RemoveAction extends SessionAction {
        private final Robots robots;
        private final RobotConnector connector;

        RemoveAction(SessionCommand.Remove remove, RobotConnector connector) {
            super(Scheduling.BESIDE, CommandTrait.CHANGES_TEAM);
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

    static final class BotsAction extends SessionAction {
        private final Team team;
        private final RobotConnector connector;

        BotsAction(Team team, RobotConnector connector) {
            super(Scheduling.OVERTAKES);
            this.team = team;
            this.connector = connector;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            TeamListing.of(team, connector).forEach(execution::answer);
        }
    }

    static final class ProbeAction extends SessionAction {
        private final Literal address;
        private final BotFactory factory;

        ProbeAction(SessionCommand.Probe probe, BotFactory factory) {
            super(Scheduling.BESIDE);
            this.address = probe.address();
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            checkAddress(address, factory);
        }

        @Override
        public void run(Execution execution) {
            String where = address.unquoted();
            execution.answer("probe " + where + ": " + factory.probe(where));
        }
    }

    static final class ReleaseAction extends SessionAction {
        private final Team team;

        ReleaseAction(Team team) {
            super(Scheduling.OVERTAKES);
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
    static final class StopAllAction extends SessionAction {
        StopAllAction() {
            super(Scheduling.STOP);
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            execution.stopEverything();
        }
    }

    static final class LabAction extends SessionAction {
        private final BotFactory factory;

        LabAction(BotFactory factory) {
            super(Scheduling.AT_ONCE);
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            if (factory.lab().isEmpty()) {
                throw new BotException("lab: no simulated lab runs here; start MAJIC with --lab");
            }
        }

        @Override
        public void run(Execution execution) {
            LabAccess lab = factory.lab().orElseThrow();
            lab.truePoses().forEach((type, pose) -> execution.answer("lab: " + type + " " + text(pose)));
        }

        private static String text(Pose pose) {
            double heading = Math.round(pose.headingDeg() * 10) / 10.0;
            return String.format(
                    Locale.ROOT, "x=%d y=%d heading=%.1f", Math.round(pose.xMm()), Math.round(pose.yMm()), heading);
        }
    }

    private static void checkAddress(Literal literal, BotFactory factory) {
        literal.at().check(() -> {
            BotAddress address = BotAddress.parse(literal.unquoted());
            if (!address.scheme().equals(BotAddress.SIMULATED)) {
                factory.type(address.type());
            }
        });
    }
}
