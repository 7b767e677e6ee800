package majic.gui.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.plot.data.Computation.Operation;
import majic.script.MajicParser;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlotByCommandWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void aLineOpensOnePlotForAllItsRobotsAndLeavesTheFocus() {
        window.add("one");
        window.add("two");
        window.command("1,2 plot x,cruise");
        window.awaitMessage("2 plot x,cruise: done");
        window.await("the curves", () -> curves().equals(List.of("1 x", "1 cruise", "2 x", "2 cruise")));
        assertThat(window.frame.isFocused()).isTrue();
        window.command("1,2 plot x,cruise");
        window.command("1 plot x");
        window.await("the second plot", () -> plots().size() == 2);
    }

    @Test
    void aScriptAndAnotherProgramOpenPlots(@TempDir Path folder) throws IOException {
        window.add("one");
        Path script = Files.writeString(folder.resolve("look.majic"), "1 plot x\n");
        window.command("run \"" + script + "\"");
        window.await("the plot", () -> plots().size() == 1);
        assertThat(MajicParser.socket(window.session).parseText("1 plot cruise"))
                .isEmpty();
        window.await("the plot", () -> plots().size() == 2);
    }

    @Test
    void aWordCannotBePlotted() {
        window.add("one");
        window.command("1 plot nonsense");
        assertThat(window.text("hint")).contains("nonsense");
        assertThat(plots()).isEmpty();
    }

    @Test
    void aCurveIsComputedFromOthersAndStaysWhenTheyAreRemoved() {
        ToyBot toy = window.add("one");
        window.command("1 plot x,y");
        window.await("the plot", () -> plots().size() == 1);
        window.push("compute");
        window.awaitDialog("Compute a Curve");
        JComboBox<?> operation = window.find("operation", JComboBox.class);
        window.run(() -> operation.setSelectedIndex(1));
        window.push("Add");
        window.await("the curve", () -> curves().equals(List.of("1 x", "1 y", "1 x \u2212 1 y")));
        window.push("remove 1 x (mm)");
        window.push("remove 1 y (mm)");
        toy.at(new Pose(70, 30, 0), false);
        Curve computed = plots().get(0).model().curves().get(0);
        window.await(
                "the difference",
                () -> computed.points().at(plots().get(0).model().source().now()) == 40);
    }

    @Test
    void aPlotOfTheSameReadingsHasItsComputedCurvesAgain() {
        window.add("one");
        window.command("1 plot x,y");
        window.await("the plot", () -> plots().size() == 1);
        PlotModel model = plots().get(0).model();
        window.run(() -> model.add(Curve.computed(Operation.SUM, model.curves(), 0)));
        window.run(
                () -> model.add(Curve.computed(Operation.SCALE, model.curves().subList(2, 3), 2)));
        List<String> all = List.of("1 x", "1 y", "1 x + 1 y", "2 \u00d7 (1 x + 1 y)");
        assertThat(curves()).isEqualTo(all);
        window.await(
                "the setting",
                () -> window.settings.get("plot.computed").orElse("").endsWith("SUM 0.0 0 1;SCALE 2.0 2"));
        window.run(() -> plots().get(0).dispose());

        window.command("1 plot x,y");
        window.await("the plot", () -> curves().equals(all));
        window.command("1 plot x");
        window.await("the other plot", () -> plots().size() == 2);
        assertThat(plots().get(1).model().curves()).hasSize(1);

        PlotModel again = plots().get(0).model();
        window.run(() -> again.curves().stream().filter(Curve::isComputed).forEach(again::remove));
        window.await(
                "the setting to go",
                () -> window.settings.get("plot.computed").orElse("").isEmpty());
    }

    @Test
    void damagedSettingsOfComputedCurvesAreLeftOut() {
        window.add("one");
        window.run(() -> window.settings.put(
                "plot.computed", "1 x = SUM 0.0 0;MEAN 1 0;SCALE nan 0;SCALE 3.0 7;;DERIVATIVE 0.0 0\nnonsense"));
        window.command("1 plot x");
        window.await("the curves", () -> curves().equals(List.of("1 x", "d(1 x)/dt")));
    }

    private List<PlotWindow> plots() {
        return Stream.of(Window.getWindows())
                .filter(found -> found instanceof PlotWindow && found.isShowing())
                .map(PlotWindow.class::cast)
                .toList();
    }

    private List<String> curves() {
        return plots().stream()
                .flatMap(plot -> plot.model().curves().stream())
                .map(Curve::name)
                .toList();
    }
}
