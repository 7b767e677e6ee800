package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests parameters and commands of the Pioneer's driver with the lab's well equipped Pioneer, in MAJIC Script. */
class PioneerParametersInLabTest {
    @AutoClose
    private final LabRig rig = LabRig.exactWithPioneer("p3dx-sh+gripper+gyro+charger");

    private final MajicBot bot = rig.add("pioneer");

    @Test
    void portsAreSetAndSeenToBeSet() throws InterruptedException {
        assertThat(rig.run("1 set digitalOut 5", "1 set digitalOut1 on", "1 get digitalOut", "1 set analogPort 3"))
                .containsExactly(
                        "1 set digitalOut 5: done",
                        "1 set digitalOut1 on: done",
                        "1 digitalOut = 7",
                        "1 set analogPort 3: done");
    }

    @Test
    void sonarArraysAreSwitchedApart() throws InterruptedException {
        assertThat(rig.run("1 set sonarPower2 off", "1 get sonarPower1,sonarPower2,sonarPower"))
                .containsExactly(
                        "1 set sonarPower2 off: done",
                        "1 sonarPower1 = on",
                        "1 sonarPower2 = off",
                        "1 sonarPower = on");
    }

    @Test
    void encodersAreRequestedOnlyWhileTheyAreRead() throws InterruptedException {
        double before = bot.get("encoderLeft").number();

        rig.run("1 move 500");

        double ticks = bot.get("encoderLeft").number() - before;
        assertThat(ticks / bot.get("ticksPerMm").number()).isCloseTo(500, within(12.0));
    }

    @Test
    void theGripperMovesAsCommandedAndReportsIt() throws InterruptedException {
        assertThat(rig.run("1 gripper close", "1 get gripper", "1 gripper deploy", "1 get gripper,lift"))
                .containsExactly(
                        "1 gripper close: gripper closed, lift up",
                        "1 gripper = closed",
                        "1 gripper deploy: gripper open, lift down",
                        "1 gripper = open",
                        "1 lift = down");
    }

    @Test
    void aStopStopsTheGripperWhereItIs() throws InterruptedException {
        rig.run("1 gripper deploy");
        AtomicReference<String> outcome = new AtomicReference<>("");
        rig.lab().time().thread("storing", () -> outcome.set(store())).start();
        rig.run("wait 1s");
        assertThat(bot.get("gripper")).hasToString("moving");

        bot.stop();

        rig.run("wait 20s");
        assertThat(outcome).hasValue("stopped");
        assertThat(bot.get("gripper")).hasToString("between");
        assertThat(bot.get("lift")).hasToString("between");
    }

    private String store() {
        try {
            return bot.run("gripper", List.of(Value.text("store")));
        } catch (MotionStopped e) {
            return String.valueOf(e.getMessage());
        }
    }

    @Test
    void badLinesSayWhatWouldBeRight() throws InterruptedException {
        assertThat(rig.run("1 set topSpeed 9000", "1 gripper wide", "1 tones 200ms", "1 set pose here"))
                .containsExactly(
                        "topSpeed 9000: outside 1 … 2200 mm/s",
                        "order wide: it is one of open, close, up, down, store, deploy, stop",
                        "tones: takes DURATION NOTE [DURATION NOTE]...",
                        "pose here: not a number in mm");
    }
}
