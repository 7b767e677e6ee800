package majicsim.pioneer.model;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** All models, read once from the two tables beside this class. */
final class ModelTable {
    private static final Map<String, List<SonarDisc>> LAYOUTS = rows("sonars.csv")
            .collect(Collectors.groupingBy(row -> row[0], Collectors.mapping(ModelTable::disc, Collectors.toList())));
    private static final List<PioneerModel> MODELS =
            rows("models.csv").map(ModelTable::model).toList();

    private ModelTable() {}

    static PioneerModel find(String subclass) {
        return MODELS.stream()
                .filter(model -> model.subclass().equalsIgnoreCase(subclass))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "there is no Pioneer model '%s'; known are %s",
                        subclass,
                        String.join(", ", subclasses()))));
    }

    /**
     * The subclass that a name with extras begins with, which may have a plus sign itself; else all before the first.
     */
    static String subclassAt(String name) {
        String lower = name.toLowerCase(Locale.ROOT) + "+";
        return MODELS.stream()
                .map(PioneerModel::subclass)
                .filter(subclass -> lower.startsWith(subclass.toLowerCase(Locale.ROOT) + "+"))
                .max(Comparator.comparingInt(String::length))
                .map(subclass -> name.substring(0, subclass.length()))
                .orElse(name.split("\\+", -1)[0]);
    }

    static List<String> subclasses() {
        return MODELS.stream().map(PioneerModel::subclass).toList();
    }

    private static SonarDisc disc(String[] row) {
        return new SonarDisc(Integer.parseInt(row[1]), number(row[2]), number(row[3]), number(row[4]));
    }

    private static PioneerModel model(String[] row) {
        return new PioneerModel(
                row[0],
                row[1],
                number(row[2]),
                number(row[3]),
                number(row[4]),
                number(row[5]),
                number(row[6]),
                new Scaling(
                        number(row[7]),
                        number(row[22]),
                        number(row[8]),
                        number(row[9]),
                        number(row[10]),
                        number(row[11])),
                Boolean.parseBoolean(row[12]),
                Integer.parseInt(row[13]),
                Integer.parseInt(row[14]),
                fitted(row[15]),
                equipment(row),
                PioneerModel.USUAL_WATCHDOG_MS);
    }

    private static Equipment equipment(String[] row) {
        return new Equipment(
                Generation.valueOf(row[16]),
                Boolean.parseBoolean(row[17]),
                Boolean.parseBoolean(row[18]),
                Integer.parseInt(row[19]),
                Boolean.parseBoolean(row[20]),
                Integer.parseInt(row[21]),
                false);
    }

    /** The discs of a layout; the table has numbers at 0, 0 where no disc is fitted. */
    private static List<SonarDisc> fitted(String layout) {
        return LAYOUTS.getOrDefault(layout, List.of()).stream()
                .filter(disc -> disc.xMm() != 0 || disc.yMm() != 0)
                .toList();
    }

    private static double number(String cell) {
        return Double.parseDouble(cell);
    }

    private static Stream<String[]> rows(String table) {
        InputStream stream = Objects.requireNonNull(ModelTable.class.getResourceAsStream(table), table);
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.US_ASCII))) {
            List<String> lines =
                    reader.lines().filter(line -> !line.startsWith("#")).skip(1).toList();
            return lines.stream().map(line -> line.split(","));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the table of Pioneer models " + table, e);
        }
    }
}
