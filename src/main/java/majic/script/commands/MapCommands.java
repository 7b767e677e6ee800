package majic.script.commands;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.nav.CurrentMap;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** The commands for the map of the team. */
final class MapCommands {
    private MapCommands() {}

    /** Describes the map there is. */
    record Show() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void run(Execution execution) {
            execution.answer("map: " + execution.session().map().text());
        }
    }

    /** Lists the cells of the map, for other programs. */
    record Rows() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void run(Execution execution) {
            OccupancyGrid grid = execution
                    .session()
                    .map()
                    .get()
                    .map(NavigationMap::grid)
                    .orElseThrow(() -> new BotException("map rows: there is no map"));
            Pose origin = grid.origin();
            execution.answer(String.format(
                    Locale.ROOT,
                    "map rows: %d rows of %d cells of %.0f mm, the top row first; lower left corner at x %.0f mm, y %.0f mm,"
                            + " heading %.1f deg; # occupied, . free, ? unknown",
                    grid.height(),
                    grid.width(),
                    grid.cellMm(),
                    origin.xMm(),
                    origin.yMm(),
                    origin.headingDeg()));
            for (int row = grid.height() - 1; row >= 0; row--) {
                execution.answer(text(grid, row));
            }
        }

        private static String text(OccupancyGrid grid, int row) {
            StringBuilder text = new StringBuilder(grid.width());
            for (int column = 0; column < grid.width(); column++) {
                text.append(
                        switch (grid.state(column, row)) {
                            case OCCUPIED -> '#';
                            case FREE -> '.';
                            case UNKNOWN -> '?';
                        });
            }
            return text.toString();
        }
    }

    /** Looks for robots everywhere on the map. */
    record Localize(Token at) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public String text() {
            return "localize";
        }

        @Override
        public void check(Check check) {
            if (check.bot().isConnected() && check.bot().rangeSensors().isEmpty()) {
                throw new ScriptException(
                        at,
                        "localize: robot " + check.robot().number()
                                + " has no range sensors; \"set pose\" places it, or dragging it on the team map");
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            for (Member member : robots) {
                execution.session().map().localize(member.bot());
                execution.answer(member.number() + " localize: looks for its place on the map; drive it some metres");
            }
        }
    }

    /** Lets a robot build a new map while it drives. */
    record Start(Token at, Robots robots) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public void check(Check check) {
            List<Member> members = check.selection().members(robots);
            if (members.size() != 1) {
                throw new ScriptException(
                        at,
                        "map start: one robot builds the map; \"map start 2\" would be right, not " + members.size()
                                + " robots");
            }
        }

        @Override
        public void run(Execution execution) {
            Member member = execution.selection().members(robots).get(0);
            execution.session().map().start(member.bot());
            execution.answer("map start " + member.number() + ": " + member.label()
                    + " builds the map while it drives; \"map stop\" ends that");
        }
    }

    /**
     * Ends the building of the map. Never refused: a refused line with the word stop is taken as STOP, which would stop
     * the robots.
     */
    record Stop() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public void run(Execution execution) {
            CurrentMap map = execution.session().map();
            boolean built = !map.mappedBy().isEmpty();
            map.stop();
            execution.answer("map stop: " + (built ? map.text() : "no robot builds a map"));
        }
    }

    /** Removes the map. */
    record Close() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void run(Execution execution) {
            execution.session().map().close();
            execution.answer("map close: done");
        }
    }

    /** Opens a map from a file. */
    record Open(Literal file) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.LOCAL_ONLY);
        }

        @Override
        public void check(Check check) {
            file.path();
        }

        @Override
        public void run(Execution execution) {
            try {
                execution.session().map().open(file.path());
            } catch (IOException e) {
                throw new BotException("map open: " + e.getMessage(), e);
            }
            execution.answer(
                    "map open " + file.text() + ": " + execution.session().map().text());
        }
    }

    /** Gives a place another name, or removes it. */
    record ChangePlace(Token name, @Nullable Token now) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void run(Execution execution) {
            CurrentMap map = execution.session().map();
            if (now == null) {
                map.remove(name.text());
            } else {
                map.rename(name.text(), now.text());
            }
            execution.answer("map place " + name.text() + (now == null ? " off" : " as " + now.text()) + ": done");
        }
    }

    /** Gives a place on the map a name. */
    record Place(Token name, Literal x, Literal y, @Nullable Literal heading) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void run(Execution execution) {
            Pose pose = new Pose(x.number(), y.number(), heading == null ? 0 : heading.number());
            execution.session().map().add(new NavigationMap.Place(name.text(), pose, heading != null));
            execution.answer(String.format(
                    Locale.ROOT, "map place %s: x %.0f mm, y %.0f mm", name.text(), pose.xMm(), pose.yMm()));
        }
    }
}
