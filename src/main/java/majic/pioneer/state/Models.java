package majic.pioneer.state;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The models by the subclass they announce in the handshake (ARCOS sheet 4, 9, 12), from two tables beside this class.
 */
public final class Models {
    /** Used until a robot has reported its model: by far the most common one. */
    public static final Model USUAL;

    private static final Map<String, Model> BY_SUBCLASS = read();

    static {
        USUAL = of("p3dx-sh");
    }

    private Models() {}

    /**
     * The model of a subclass, in any case; laser variants count as the plain model. An unknown one counts as large and
     * slow, without a scale and without sonars of known position.
     */
    public static Model of(String subclass) {
        String plain = subclass.strip().toLowerCase(Locale.ROOT).replaceFirst("-(lms|tim)\\d.*$", "");
        Model model = BY_SUBCLASS.get(plain);
        return model != null ? model : unknown(subclass);
    }

    private static Model unknown(String subclass) {
        return new Model(subclass, false, new Hull(400, 400, 300), List.of(), Scaling.UNKNOWN, 300, 50, 0, 0);
    }

    private static Map<String, Model> read() {
        Map<String, List<SonarDisc>> layouts = new HashMap<>();
        rows("sonars.csv").forEach(row -> layouts.merge(row[0], List.of(disc(row)), Models::joined));
        Map<String, Model> models = new HashMap<>();
        rows("models.csv").forEach(row -> models.put(row[0], model(row, layouts)));
        return Map.copyOf(models);
    }

    private static List<SonarDisc> joined(List<SonarDisc> some, List<SonarDisc> more) {
        return Stream.concat(some.stream(), more.stream()).toList();
    }

    private static SonarDisc disc(String[] row) {
        return new SonarDisc(Integer.parseInt(row[1]), number(row[2]), number(row[3]), number(row[4]));
    }

    private static Model model(String[] row, Map<String, List<SonarDisc>> layouts) {
        List<SonarDisc> discs = layouts.getOrDefault(row[1], List.of());
        return new Model(
                row[0],
                true,
                hull(row, discs),
                discs,
                new Scaling(number(row[6]), 360.0 / number(row[12]), number(row[7]), number(row[8]), number(row[9])),
                number(row[4]),
                number(row[5]),
                Integer.parseInt(row[10]),
                Integer.parseInt(row[11]));
    }

    private static Hull hull(String[] row, List<SonarDisc> discs) {
        double length = number(row[2]);
        double front = number(row[13]);
        return front == 0
                ? Hull.around(discs, length, number(row[3]))
                : new Hull(front, length - front, number(row[3]) / 2);
    }

    private static double number(String cell) {
        return Double.parseDouble(cell);
    }

    private static List<String[]> rows(String table) {
        try (InputStream stream = Models.class.getResourceAsStream(table)) {
            if (stream == null) {
                throw new IllegalStateException("the table " + table + " is missing from the program");
            }
            BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8));
            return reader.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(",\\s*"))
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
