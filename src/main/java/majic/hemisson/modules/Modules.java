package majic.hemisson.modules;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Collectors;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.hemisson.line.Reply;
import majic.hemisson.readings.RobotReadings;
import org.jspecify.annotations.Nullable;

/**
 * What is plugged into a robot's I2C bus. Immutable.
 *
 * @param found the modules in the order of their addresses
 * @param roadNarrows whether the firmware has commands of its own for them
 */
public record Modules(List<Found> found, boolean roadNarrows) {
    public static final Modules NONE = new Modules(List.of(), false);

    /** The names of all commands that modules bring. */
    public static final List<String> COMMANDS = List.of("phrase", "say", "lcd", "lcdClear");

    /**
     * A module that answered.
     *
     * @param address as the robot reports it, hex
     * @param kind null for an unknown module
     */
    record Found(String address, @Nullable ModuleKind kind) {
        String name() {
            return (kind == null ? "unknown" : kind.label()) + " at " + address;
        }
    }

    public Modules {
        found = List.copyOf(found);
    }

    /** Reads the answer to a scan: addresses, or with a letter before and a version behind each. */
    public static Modules of(Reply scan) {
        String[] words = scan.rest().isEmpty() ? new String[0] : scan.rest().split(",");
        List<Found> found = new ArrayList<>();
        boolean letters = words.length > 0 && words[0].length() == 1;
        for (int index = 0; index < words.length; index += letters ? 3 : 1) {
            if (!letters && words[index].matches("[0-9A-Fa-f]{2}")) {
                int address = Integer.parseInt(words[index], 16);
                found.add(new Found(words[index].toUpperCase(Locale.ROOT), ModuleKind.at(address)));
            } else if (letters && words[index].length() == 1 && index + 1 < words.length) {
                found.add(new Found(words[index + 1], ModuleKind.of(words[index].charAt(0))));
            }
        }
        return new Modules(found, letters);
    }

    /** The names of the modules, for users. */
    public String names() {
        return found.isEmpty() ? "none" : found.stream().map(Found::name).collect(Collectors.joining(", "));
    }

    public void describe(ParameterTable table, RobotReadings access) {
        known().forEach(module -> module.describe(table, access));
    }

    public List<DriverCommand> commands(RobotReadings access) {
        return known().stream()
                .flatMap(module -> module.commands(access).stream())
                .toList();
    }

    private List<ExtensionModule> known() {
        return found.stream()
                .map(Found::kind)
                .filter(Objects::nonNull)
                .distinct()
                .map(kind -> kind.module(roadNarrows))
                .filter(Objects::nonNull)
                .toList();
    }
}
