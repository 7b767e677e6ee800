package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import majic.program.FirstRobots;
import majic.program.Program;
import majic.program.UserFolder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class StartOptionsTest {
    @Test
    void theRobotsOfTheLabAreAddedInItsOrder() {
        assertThat(StartOptions.labLines(List.of("aibo", "pioneer"), 20))
                .containsExactly("add sim:aibo as 1", "add sim:pioneer as 2");
    }

    @Test
    void ofALargeLabAsManyRobotsAreAddedAsATeamHasNumbers() {
        assertThat(StartOptions.labLines(Collections.nCopies(502, "pioneer"), 200))
                .hasSize(200);
    }

    @Test
    void theUsualLabStartsWhenItsRobotsAreAddedSoThatTheWindowIsVisibleBefore(@TempDir Path folder) throws IOException {
        StartOptions options = options(folder, "--lab");
        try (Program program = options.program(new UserFolder(folder), true)) {
            assertThat(program.lab()).isNull();
            assertThat(options.firstRobots(program))
                    .isEqualTo(new FirstRobots(
                            List.of("add sim:aibo as 1", "add sim:pioneer as 2", "add sim:hemisson as 3"), List.of()));
            assertThat(program.lab()).isNotNull();
        }
    }

    @Test
    void robotsOfTheCommandLineFollowThoseOfTheLab(@TempDir Path folder) throws IOException {
        StartOptions options = options(folder, "--lab", "--add=sim:pioneer", "--add=sim:aibo");
        try (Program program = options.program(new UserFolder(folder), true)) {
            FirstRobots robots = options.firstRobots(program);

            assertThat(robots.ofLab()).hasSize(3);
            assertThat(robots.requested()).containsExactly("add sim:pioneer", "add sim:aibo");
        }
    }

    @Test
    void aLabWithOptionsOfItsOwnStartsBeforeTheWindow(@TempDir Path folder) throws IOException {
        StartOptions options = options(folder, "--lab", "--exact", "--aibo-port=0", "--pioneer-port=0");
        try (Program program = options.program(new UserFolder(folder), true)) {
            assertThat(program.lab()).isNotNull();
        }
    }

    private static StartOptions options(Path folder, String... arguments) {
        MajicCommand command = new MajicCommand(new UserFolder(folder));
        new CommandLine(command).parseArgs(arguments);
        return command.start();
    }
}
