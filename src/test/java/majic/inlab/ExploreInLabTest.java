package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majic.bot.Pose;
import majic.inlab.acts.ActLabs;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.Test;

/** Pioneers with lasers that explore the lab and the office. */
class ExploreInLabTest {
    /** A robot can be at a place that is as far from all walls. */
    private static final double ROOM_MM = 320;

    private static final int STEP_MM = 200;

    private static LabOptions lab() {
        return LabOptions.exactOnFreePorts().withPioneer("p3dx-sh+laser");
    }

    private static LabOptions office() {
        try {
            return lab().withPioneers(2).withRoom(Room.load(Path.of("sims", "worlds", "office.map")));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static int contacts(LabRig rig) {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
    }

    /** Returns which part of the floor that a robot can reach from where it is the map has. */
    private static double known(LabRig rig, Pose from) {
        OccupancyGrid grid = rig.session().map().get().map(NavigationMap::grid).orElseThrow();
        Set<List<Integer>> reached = new HashSet<>();
        ArrayDeque<List<Integer>> next = new ArrayDeque<>();
        next.add(List.of((int) from.xMm() / STEP_MM, (int) from.yMm() / STEP_MM));
        while (!next.isEmpty()) {
            List<Integer> at = next.remove();
            if (ActLabs.toTheWalls(rig, new Pose(at.get(0) * STEP_MM, at.get(1) * STEP_MM, 0)) > ROOM_MM
                    && reached.add(at)) {
                next.add(List.of(at.get(0) + 1, at.get(1)));
                next.add(List.of(at.get(0) - 1, at.get(1)));
                next.add(List.of(at.get(0), at.get(1) + 1));
                next.add(List.of(at.get(0), at.get(1) - 1));
            }
        }
        long free = reached.stream()
                .filter(at -> grid.stateAt(at.get(0) * STEP_MM, at.get(1) * STEP_MM) == OccupancyGrid.State.FREE)
                .count();
        return (double) free / reached.size();
    }

    private static double seconds(LabRig rig) {
        return rig.lab().time().nanos() / 1e9;
    }

    @Test
    void itBeginsAMapAndExploresTheWholeRoomWithoutAContact() throws InterruptedException {
        try (LabRig rig = LabRig.of(lab())) {
            rig.add("pioneer");
            Pose begun = rig.truePose("pioneer");

            assertThat(rig.run("1 explore"))
                    .last()
                    .asString()
                    .matches("1 explore: done \\(\\d+ frontiers, [56]\\d m², \\d+\\.\\d s\\)");
            assertThat(known(rig, begun)).isGreaterThan(0.98);
            assertThat(contacts(rig)).isZero();
            assertThat(seconds(rig)).isLessThan(180);
        }
    }

    @Test
    void twoRobotsShareTheRoomsOfAnOffice() throws InterruptedException {
        try (LabRig rig = LabRig.of(office())) {
            rig.add("pioneer");
            rig.add("pioneer2");
            Pose begun = rig.truePose("pioneer");

            assertThat(rig.run("1,2 explore"))
                    .anyMatch(line -> line.startsWith("1 explore: done ("))
                    .anyMatch(line -> line.startsWith("2 explore: done ("));
            assertThat(known(rig, begun)).isGreaterThan(0.98);
            assertThat(contacts(rig)).isZero();
            assertThat(seconds(rig)).isLessThan(600);
        }
    }

    @Test
    void aStopEndsItAndTheMapStays() throws InterruptedException {
        try (LabRig rig = LabRig.of(lab())) {
            rig.add("pioneer");
            rig.say("1 explore");
            rig.lab().time().sleep(20);
            rig.run("1 stop");
            Pose stood = rig.truePose("pioneer");
            rig.lab().time().sleep(5);

            assertThat(rig.truePose("pioneer").distanceMm(stood)).isZero();
            assertThat(rig.session().map().get()).isPresent();
        }
    }

    @Test
    void aConditionEndsIt() throws InterruptedException {
        try (LabRig rig = LabRig.of(lab())) {
            rig.add("pioneer");

            assertThat(rig.run("1 explore until y > 1000"))
                    .last()
                    .asString()
                    .startsWith("1 explore until y > 1000: done (");
            assertThat(rig.truePose("pioneer").yMm()).isBetween(1000.0, 1300.0);
        }
    }

    @Test
    void aMapThatNoRobotBuildsIsRefused() throws InterruptedException {
        try (LabRig rig = LabRig.of(lab())) {
            rig.add("pioneer");

            assertThat(rig.run("map start 1", "1 move 100", "1 wait", "map stop", "1 explore"))
                    .last()
                    .asString()
                    .contains("1 explore: failed: explore: robot 1 (Pioneer) does not build the map that there is");
        }
    }

    @Test
    void itFailsWhenTheMapIsFinishedMeanwhile() throws InterruptedException {
        try (LabRig rig = LabRig.of(lab())) {
            rig.add("pioneer");
            rig.say("1 explore");
            rig.lab().time().sleep(20);

            assertThat(rig.run("map stop", "1 wait"))
                    .anyMatch(line -> line.contains("1 explore: failed: it builds the map no longer"));
        }
    }
}
