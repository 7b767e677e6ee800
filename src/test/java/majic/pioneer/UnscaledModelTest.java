package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.BotException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A robot of a model that is in no table, with and without the maker's parameter file. */
class UnscaledModelTest {
    @TempDir
    private Path folder;

    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    @BeforeEach
    void countInTheRobotsOwnUnits() {
        robot.subclass = "p9xl";
        robot.mmPerCount = 0.5813;
    }

    @Test
    void moveAndTurnAreRefusedWithWhatHelps() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            String help = "scale of its model p9xl is not known";
            assertThat(stage.notices).anyMatch(notice -> notice.contains(help));
            assertThatThrownBy(() -> stage.bot.move(200))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining(help)
                    .hasMessageContaining("add pioneer:" + stage.line.address() + "?params=p9xl.p");
            assertThatThrownBy(() -> stage.bot.turn(90)).hasMessageContaining(help);

            assertThat(robot.heard).noneMatch(command -> command.matches("(ENABLE 1|VEL|RVEL).*"));
        }
    }

    @Test
    void driveIsAllowedSlowly() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            stage.bot.drive(100, 0, 1, () -> false);

            assertThat(robot.robot.x()).isGreaterThan(50);
            assertThat(stage.bot.profile().speed().max()).isEqualTo(300);
            assertThat(robot.heard).contains("SETV 300", "SETRV 50");
        }
    }

    @Test
    void whatNeedsTheScaleIsUnknown() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            stage.bot.drive(100, 20, 1, () -> false);

            for (String name : new String[] {"x", "y", "heading", "pose", "speed", "turnRate", "wheelLeft", "sonar0"}) {
                assertThat(stage.bot.get(name)).as(name).hasToString("unknown (the scale of this model is not known)");
            }
            assertThat(stage.bot.state().pose().xMm()).isZero();
        }
    }

    @Test
    void aRobotWithItsParameterFileMovesByItsScale() throws IOException {
        Path file = Files.writeString(folder.resolve("p9xl.p"), """
                Section Conversion factors
                DistConvFactor 0.58130   ; multiplier to mm from robot units
                """);
        try (PioneerRig stage = new PioneerRig(robot, "?params=" + file)) {
            stage.bot.connect();
            stage.bot.move(400);
            stage.bot.turn(90);

            assertThat(robot.robot.x()).isBetween(390.0, 410.0);
            assertThat(robot.robot.heading()).isBetween(89.0, 91.0);
            assertThat(stage.notices).noneMatch(notice -> notice.contains("scale"));
        }
    }

    @Test
    void aFileForAnotherModelIsNoticed() throws IOException {
        Path file = Files.writeString(folder.resolve("a.p"), "Subclass p3at\nDistConvFactor 0.465\n");
        try (PioneerRig stage = new PioneerRig(robot, "?params=" + file)) {
            stage.bot.connect();

            assertThat(stage.notices)
                    .anyMatch(notice -> notice.contains("for the model p3at, but it calls itself p9xl"));
        }
    }

    @Test
    void aWrongOptionIsRefusedWithTheRightOne() {
        assertThatThrownBy(() -> new MajicPioneer("pioneer://10.0.0.5?parameters=a.p"))
                .hasMessageContaining("parameters=a.p is no option")
                .hasMessageContaining("params=FILE");
        assertThatThrownBy(() -> new MajicPioneer("pioneer:/dev/ttyS9?params=" + folder.resolve("none.p")))
                .hasMessage(folder.resolve("none.p") + ": there is no such parameter file");
    }
}
