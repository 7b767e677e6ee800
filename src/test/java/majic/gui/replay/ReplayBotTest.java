package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.recorder.Recorder;
import majic.recorder.Recording;
import majic.recorder.RecordingFolder;
import majic.recorder.RobotTracks;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recorded robot has the recorded state, and refuses to do anything. */
class ReplayBotTest {
    @TempDir
    private Path folder;

    private final List<ReplayBot> bots = new ArrayList<>();
    private Recording recording;

    @BeforeEach
    void record() throws Exception {
        RecordingFolder files = new RecordingFolder(folder);
        try (LabRig rig = LabRig.exact()) {
            Recorder recorder = new Recorder(rig.team(), rig.session().factory(), files, problem -> {});
            recorder.start();
            rig.withAllRobots();
            rig.run("2 move 200", "3 set ledLeft on");
            recorder.close();
            for (RobotTracks tracks : Recording.read(files.files().get(0)).tracks()) {
                bots.add(new ReplayBot(
                        rig.session().factory().type(tracks.robot().type()), tracks));
            }
        }
        recording = Recording.read(files.files().get(0));
        bots.forEach(bot -> bot.show(recording.endS()));
    }

    @AfterEach
    void close() {
        bots.forEach(ReplayBot::close);
    }

    @Test
    void itHasTheRecordedParametersAndState() {
        ReplayBot pioneer = bots.get(1);
        assertThat(pioneer.state().pose().xMm()).isBetween(185.0, 215.0);
        assertThat(pioneer.get("x").number()).isEqualTo(pioneer.state().pose().xMm());
        assertThat(pioneer.get("motors")).isEqualTo(Value.yesNo(true));
        assertThat(pioneer.isConnected()).isTrue();
        assertThat(bots.get(2).get("ledLeft")).isEqualTo(Value.onOff(true));
    }

    @Test
    void itRefusesEveryCommand() {
        for (ReplayBot bot : bots) {
            assertThatThrownBy(() -> bot.move(1))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("replay");
            assertThatThrownBy(() -> bot.turn(1))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("replay");
            assertThatThrownBy(() -> bot.drive(1, 0))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("replay");
            assertThat(bot.commands()).isEmpty();
            assertThat(bot.membership()).isEmpty();
        }
        assertThatThrownBy(() -> bots.get(2).set("ledLeft", List.of(Value.onOff(false))))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("replay");
    }

    @Test
    void itIsNotConnectedBeforeItJoined() {
        ReplayBot hemisson = bots.get(2);
        hemisson.show(0);
        assertThat(hemisson.isConnected()).isFalse();
        hemisson.show(recording.endS());
        assertThat(hemisson.isConnected()).isTrue();
    }
}
