package majic.gui.help;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import javax.swing.table.DefaultTableModel;
import javax.swing.table.TableModel;
import majic.bot.Parameter;
import majic.script.commands.ParameterGroup;
import majic.team.Member;
import majic.text.Texts;

/** Creates the tables that the help shows. */
final class HelpTables {
    private static final Texts TEXTS = Texts.of(HelpTables.class);

    private HelpTables() {}

    /** Reads a two-column table from a text resource whose columns are separated by a tab. */
    static TableModel file(String name, String left, String right) {
        Table table = new Table(left, right);
        try (InputStream in = HelpTables.class.getResourceAsStream(name + ".tsv");
                BufferedReader lines = new BufferedReader(
                        new InputStreamReader(Objects.requireNonNull(in, name), StandardCharsets.UTF_8))) {
            lines.lines().map(line -> line.split("\t")).forEach(table::addRow);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return table;
    }

    /** Returns the table of parameters without rows. */
    static DefaultTableModel noParameters() {
        return new Table(TEXTS.get("name"), TEXTS.get("values"), TEXTS.get("access"), TEXTS.get("meaning"));
    }

    /**
     * Lists the parameters that can be read and set on a robot, and the commands that only this robot has. Callable
     * from any thread.
     */
    static TableModel of(Member member) {
        DefaultTableModel table = noParameters();
        for (ParameterGroup group : ParameterGroup.of(member.bot().parameters())) {
            Parameter parameter = group.first();
            table.addRow(new Object[] {group.name(), values(parameter), access(parameter), parameter.help()});
        }
        member.bot()
                .commands()
                .forEach(command ->
                        table.addRow(new Object[] {command.usage(), "", TEXTS.get("access.command"), command.help()}));
        return table;
    }

    private static String values(Parameter parameter) {
        List<String> choices = parameter.choices();
        return switch (parameter.kind()) {
            case NUMBER -> (parameter.range() + " " + parameter.unit().symbol()).strip();
            case YES_NO -> String.join(", ", "yes", "no");
            case ON_OFF -> String.join(", ", "on", "off");
            case CHOICE -> String.join(", ", choices);
            case TEXT -> TEXTS.get("values.text");
            case LIST -> TEXTS.get("values.several", parameter.unit().symbol()).strip();
        };
    }

    private static String access(Parameter parameter) {
        if (!parameter.writable()) {
            return "get";
        }
        String set = parameter.moves() ? TEXTS.get("access.moves") : "set";
        return parameter.readable() ? "get, " + set : set;
    }

    /** A table model that cannot be edited. */
    private static final class Table extends DefaultTableModel {
        private static final long serialVersionUID = 1L;

        Table(Object... columns) {
            super(columns, 0);
        }

        @Override
        public boolean isCellEditable(int row, int column) {
            return false;
        }
    }
}
