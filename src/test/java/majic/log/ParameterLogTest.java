package majic.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the parameter log is a table of comma-separated values. */
class ParameterLogTest {
    @TempDir
    Path folder;

    @Test
    void hasARowForEachReading() throws IOException {
        ParameterLog log = new ParameterLog();
        log.add(0.1, 1, "x", Value.about(12.345678, Unit.MM));
        log.add(0.2, 1, "distanceFront", Value.CLEAR);
        log.add(0.3, 2, "sonar", Value.many(List.of(Value.of(1, Unit.MM), Value.of(2, Unit.MM))));
        log.add(0.4, 2, "title", Value.text("a \"b\""));
        log.add(0.5, 2, "x", Value.unknown("no word, yet"));
        log.add(0.6, 2, "title", Value.text("two\nlines\u001b[2J"));
        Path file = folder.resolve("log.csv");
        log.save(file);
        assertThat(Files.readAllLines(file))
                .containsExactly(
                        "time_s,robot,parameter,value,unit",
                        "0.100,1,x,12.345678,mm",
                        "0.200,1,distanceFront,inf,",
                        "0.300,2,sonar,\"1 mm, 2 mm\",",
                        "0.400,2,title,\"a \"\"b\"\"\",",
                        "0.500,2,x,,",
                        "0.600,2,title,two\\nlines\\u001b[2J,");
    }

    @Test
    void losesNothingWhenItGrowsBeyondTheMemoryItMayUse() throws IOException {
        ParameterLog log = new ParameterLog();
        for (int reading = 0; reading < 10_000; reading++) {
            log.add(reading, 1, "x", Value.of(reading, Unit.MM));
        }
        Path file = folder.resolve("log.csv");
        log.save(file);
        log.save(file);
        assertThat(Files.readAllLines(file)).hasSize(10_001).contains("9999.000,1,x,9999.0,mm", "0.000,1,x,0.0,mm");
    }

    @Test
    void readingsBeyondItsLimitAreReportedAsMissing() {
        ParameterLog log = new ParameterLog(5000);
        for (int reading = 0; reading < 10_000; reading++) {
            log.add(reading, 1, "x", Value.of(reading, Unit.MM));
        }
        assertThatThrownBy(() -> log.save(folder.resolve("log.csv")))
                .isInstanceOf(IOException.class)
                .hasMessage("4096 readings are missing, there was no room for them");
    }
}
