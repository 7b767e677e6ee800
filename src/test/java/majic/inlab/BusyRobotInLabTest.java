package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import majic.bot.ConnectFailed;
import majic.bot.MajicBot;
import majic.bot.Pose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A second program at a robot that has room for one client. */
class BusyRobotInLabTest {
    @ParameterizedTest
    @ValueSource(strings = {"pioneer", "hemisson"})
    void theSecondProgramFindsTheRobotBusyAndTheFirstOneKeepsIt(String type) {
        try (LabRig rig = LabRig.exact()) {
            MajicBot first = rig.add(type);
            try (MajicBot second = rig.session().factory().create("sim:" + type)) {
                ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, second::connect);

                assertThat(failure.reason()).isEqualTo(ConnectFailed.Reason.BUSY);
                assertThat(failure).hasMessageContaining("connected to it");
            }
            Pose start = rig.truePose(type);
            first.move(50);
            assertThat(rig.truePose(type).distanceMm(start)).isGreaterThan(30);
        }
    }
}
