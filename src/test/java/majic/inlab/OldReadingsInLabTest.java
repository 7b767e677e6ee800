package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests with each robot that an old reading is never shown or used as a new one. */
class OldReadingsInLabTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"aibo", "pioneer", "hemisson"})
    void nothingThatALostRobotReportedIsAPresentValue(String type) throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add(type);
            loseFor(3, rig, type, bot);

            assertThat(rig.run("1 get now x,distanceFront,moving"))
                    .singleElement()
                    .asString()
                    .contains("failed: connection lost; at the last report, ", " s ago: x = ", "moving = no");
            assertThat(rig.run("1 get x"))
                    .singleElement()
                    .asString()
                    .startsWith("1 x = unknown (connection lost; ")
                    .contains(" at the last report, ");
            assertThat(rig.run("if 1 x > -100", "1 move 10", "end"))
                    .singleElement()
                    .asString()
                    .endsWith("1 x is unknown (connection lost)");
            assertThat(bot.parameters().stream()
                            .filter(Parameter::readable)
                            .map(Parameter::name)
                            .filter(name -> !(bot.get(name) instanceof Value.Unknown)))
                    .contains("age", "body", "cruise", "cruiseTurn", "maxMove", "near")
                    .containsAll(bot.calibration())
                    .doesNotContain("x", "y", "heading", "pose", "speed", "turnRate", "moving", "distanceFront");
        }
    }

    /** A stationary Pioneer may be silent for 3 s before its connection is given up. */
    @Test
    void aSilentPioneerHasNoReadingsAlthoughItIsConnected() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add("pioneer");
            rig.lab().simulators().faults("pioneer").outage(2.5);
            rig.lab().time().sleep(2);

            assertThat(bot.isConnected()).isTrue();
            assertThat(rig.run("1 get now x,distanceFront"))
                    .as("waits for the next report")
                    .first()
                    .isEqualTo("1 x = 0 mm");
            assertThat(bot.get("age").number()).isLessThan(1000);
        }
    }

    @Test
    void theParameterLogOfALostRobotEnds() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add("pioneer");
            rig.run("1 log x,distanceFront every 100ms", "wait 1s");
            loseFor(3, rig, "pioneer", bot);
            Path file = folder.resolve("log.csv");
            rig.run("save log " + file);

            List<String> rows = Files.readAllLines(file);
            double lastS = Double.parseDouble(rows.get(rows.size() - 1).split(",")[0]);
            assertThat(lastS).isLessThan(2.5);
        }
    }

    private static void loseFor(double seconds, LabRig rig, String type, MajicBot bot) throws InterruptedException {
        rig.lab().simulators().faults(type).cut();
        rig.await(() -> !bot.isConnected());
        rig.lab().time().sleep(seconds);
    }
}
