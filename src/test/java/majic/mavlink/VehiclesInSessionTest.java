package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a session does with every robot, with the vehicles of the simulated lab. */
class VehiclesInSessionTest {
    @Test
    void aProbeNamesTheVehicleAndLeavesItFree() {
        try (LabRig rig = LabRig.exactWithMavlink("rover+ready,copter+ready")) {
            assertThat(rig.session().factory().probe("sim:mavlink"))
                    .matches("a MAVLink .*\\(rover, system 1, version 4\\.6\\.0\\) answers");
            assertThat(rig.session().factory().probe("sim:mavlink2"))
                    .matches("a MAVLink .*\\(copter, system 2, version 4\\.6\\.0\\) answers");
            assertThat(rig.add("mavlink").isConnected()).isTrue();
        }
    }

    /** A fence is a decision for one place and one day. */
    @Test
    void aSavedTeamHasTheVehiclesAgainAndNoFence(@TempDir Path folder) throws Exception {
        Path saved = folder.resolve("lab.team");
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready,rover+ready")) {
            rig.run("add sim:mavlink", "add sim:mavlink2", "1 name Fly", "1 set fence 5000 500 4000", "1 arm");
            rig.run("save team \"" + saved + "\"");
        }

        try (LabRig again = LabRig.exactWithMavlink("copter+ready,rover+ready")) {
            assertThat(again.run("run \"" + saved + "\"")).noneMatch(line -> line.contains("failed"));
            assertThat(again.team().listing()).isEqualTo("robots: 1 Fly (Copter), 2 Rover");
            assertThat(again.run("1 get model,armed,fence", "2 get model"))
                    .contains("1 model = copter 4.6.0", "1 armed = no", "1 fence = unknown (not set)")
                    .contains("2 model = rover 4.6.0");
        }
    }

    /** So the example of a flight waits until the copter is on the ground. */
    @Test
    void theStopAtTheEndOfAnActEndsALanding(@TempDir Path folder) throws Exception {
        Path script = Files.writeString(folder.resolve("Hop.majic"), "me arm\nme takeoff 2000\nme land\n");
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready,rover+ready")) {
            MajicBot copter = rig.add("mavlink");
            rig.add("mavlink2");
            rig.lab().time().sleep(2);

            assertThat(rig.run("2 act \"" + script + "\"")).anyMatch(line -> line.contains("robot 2 has no command "));
            rig.run("1 set fence 5000 500 5000", "1 act \"" + script + "\"");
            rig.lab().time().sleep(10);

            assertThat(copter.get("mode")).hasToString("BRAKE");
            assertThat(copter.heightMm().orElseThrow()).isGreaterThan(1000);
        }
    }

    @Test
    void aMoveEndsByTheHeightOfAnotherRobot() throws InterruptedException {
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready,rover+ready")) {
            rig.lab().place("mavlink2", new Pose(1200, 0, 0));
            rig.add("mavlink");
            rig.add("mavlink2");
            rig.lab().time().sleep(2);
            Pose start = rig.truePose("mavlink2");
            rig.run("1 set fence 5000 500 5000", "1 arm", "2 arm");

            rig.say("1 takeoff 2500");
            List<String> said = rig.run("2 move 2500 until 1 altitude > 500");

            assertThat(said).anyMatch(line -> line.contains("move 2500 until 1 altitude > 500: done"));
            assertThat(rig.truePose("mavlink2").distanceMm(start)).isBetween(50.0, 2000.0);
        }
    }
}
