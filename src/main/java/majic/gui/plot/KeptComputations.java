package majic.gui.plot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;
import majic.gui.plot.data.Computation;
import majic.gui.plot.data.Computation.Operation;
import majic.gui.plot.data.CurvePoints;

/**
 * The computed curves of plots, kept in the settings: a plot of the same readings has them again. A line of the setting
 * has the readings of a plot and its formulas, whose operands are numbered: the readings from 0 on, then the formulas.
 * Must be used on the event dispatch thread.
 */
final class KeptComputations {
    private static final String KEY = "plot.computed";
    private static final int MOST_PLOTS = 50;
    private static final String FORMULAS = " = ";

    private final Settings settings;

    KeptComputations(Settings settings) {
        this.settings = settings;
    }

    private static List<Curve> measured(PlotModel model) {
        return model.curves().stream().filter(curve -> !curve.isComputed()).toList();
    }

    private static String readings(PlotModel model) {
        return measured(model).stream().map(curve -> curve.quantity().title()).collect(Collectors.joining(","));
    }

    private Stream<String> lines() {
        return settings.get(KEY).orElse("").lines();
    }

    /** Keeps the computed curves of a plot; those of which an operand was removed from the plot are left out. */
    void keep(PlotModel model) {
        List<CurvePoints> numbered =
                new ArrayList<>(measured(model).stream().map(Curve::points).toList());
        List<String> formulas = new ArrayList<>();
        for (Curve curve : model.curves()) {
            if (curve.points() instanceof Computation computation && numbered.containsAll(computation.operands())) {
                formulas.add(computation.operation() + " " + computation.number()
                        + computation.operands().stream()
                                .map(operand -> " " + numbered.indexOf(operand))
                                .collect(Collectors.joining()));
                numbered.add(computation);
            }
        }
        String start = readings(model) + FORMULAS;
        Stream<String> own = formulas.isEmpty() ? Stream.of() : Stream.of(start + String.join(";", formulas));
        String text = Stream.concat(own, lines().filter(line -> !line.startsWith(start)))
                .limit(MOST_PLOTS)
                .collect(Collectors.joining("\n"));
        BackgroundSettings.put(settings, KEY, text);
    }

    /** Adds the curves that were kept of a plot of the same readings. */
    void restore(PlotModel model) {
        String start = readings(model) + FORMULAS;
        List<Curve> numbered = new ArrayList<>(measured(model));
        lines().filter(line -> line.startsWith(start))
                .flatMap(line -> Stream.of(line.substring(start.length()).split(";")))
                .forEach(formula -> computation(formula, numbered).ifPresent(computation -> {
                    model.add(computation);
                    model.curves().stream()
                            .filter(curve -> curve.points() == computation)
                            .forEach(numbered::add);
                }));
    }

    /** Reads a formula; empty if it is damaged. */
    private static Optional<Computation> computation(String formula, List<Curve> numbered) {
        String[] words = formula.split(" ");
        try {
            Operation operation = Operation.valueOf(words[0]);
            double number = Double.parseDouble(words[1]);
            List<Curve> operands = Arrays.stream(words)
                    .skip(2)
                    .map(Integer::valueOf)
                    .map(numbered::get)
                    .toList();
            return operands.size() == (operation.hasTwo() ? 2 : 1) && Double.isFinite(number)
                    ? Optional.of(Curve.computed(operation, operands, number))
                    : Optional.empty();
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            return Optional.empty();
        }
    }
}
