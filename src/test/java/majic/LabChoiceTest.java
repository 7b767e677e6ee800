package majic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

class LabChoiceTest {
    private final LabChoice choice = new LabChoice();
    private final CommandLine line = new CommandLine(new Options(choice));

    @Test
    void thePioneersModelIsChosenInAnyCase() throws IOException {
        line.parseArgs("--pioneer-model", "P3AT-sh");
        assertThat(choice.options().pioneerModel()).isEqualTo("p3at-sh");
        assertThat(choice.isGiven()).isTrue();
    }

    @Test
    void withoutAChoiceItIsTheStandardOne() throws IOException {
        line.parseArgs();
        assertThat(choice.options().pioneerModel()).isEqualTo("p3dx-sh");
        assertThat(choice.isGiven()).isFalse();
    }

    @Test
    void aModelThatIsNoneIsRefusedWithTheListOfThoseThereAre() {
        line.parseArgs("--pioneer-model", "r2d2");
        assertThatThrownBy(choice::options)
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith("--pioneer-model r2d2: there is no Pioneer model 'r2d2'; known are p3dx, ");
    }

    @Test
    void theHelpListsTheModels() {
        assertThat(line.getUsageMessage()).contains("amigo-sh", "powerbot-sh", "pioneer-lx");
    }

    @CommandLine.Command
    private static final class Options {
        @CommandLine.Mixin
        private final LabChoice choice;

        Options(LabChoice choice) {
            this.choice = choice;
        }
    }
}
