package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.devices.Tone;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests how the driver reports events at the robot itself, with the lab's Pioneer on the lab's stepped clock. */
class PioneerDevicesInLabTest {
    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot bot = rig.add("pioneer");

    @Test
    void theStopButtonEndsAMotionAndShows() throws InterruptedException {
        Guard press = () -> {
            beside(handling -> handling.pressStop(rig.truePose("pioneer").xMm() > 300));
            return false;
        };

        assertThatThrownBy(() -> bot.move(2000, press)).hasMessageContaining("STOP button");

        assertThat(rig.truePose("pioneer").xMm()).isBetween(300.0, 600.0);
        assertThat(bot.get("stopButton")).hasToString("yes");
        beside(handling -> handling.pressStop(false));
        rig.run("wait 0.3s");
        assertThat(bot.get("stopButton")).hasToString("no");
        assertThat(bot.move(100).amount().number()).isBetween(90.0, 110.0);
    }

    @Test
    void theStateOfTheBatteryIsReported() {
        assertThat(bot.get("voltage").number()).isEqualTo(13.0);
        assertThat(bot.get("battery").number()).isEqualTo(100.0);
    }

    @Test
    void aRestartOfTheControllerIsALostLink() throws InterruptedException {
        beside(PioneerHandling::pressReset);

        assertThat(rig.await(() -> !bot.isConnected())).isTrue();
    }

    @Test
    void itsBuzzerSounds() throws InterruptedException {
        List<Tone> heard = new ArrayList<>();
        assertThat(rig.run("1 set beep on")).containsExactly("1 set beep on: done");
        rig.lab().time().sleep(0.1);
        beside(handling -> heard.addAll(handling.played()));
        assertThat(heard).isNotEmpty();
    }

    private void beside(Consumer<PioneerHandling> deed) {
        rig.lab().simulators().besidePioneer(deed);
    }
}
