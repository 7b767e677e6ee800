package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the shipped behaviours for more than one robot. */
@Tag("long")
class TeamActsInLabTest {
    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs();
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theGuardStopsAllRobotsWhenAnObstacleComesNear(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get().withAllRobots()) {
            rig.lab().time().sleep(3);
            rig.say("2 act Guard");
            rig.say("1,3 move 1m");
            rig.lab().time().sleep(5);
            assertThat(rig.team().isLatched()).isFalse();

            ActLabs.place(rig, "hemisson", new Pose(700, 0, 0));
            rig.lab().time().sleep(1);
            assertThat(rig.team().isLatched()).isTrue();
            assertThat(rig.said()).contains("1 move 1m: stopped", "3 move 1m: stopped", "2 act Guard: stopped");
            Map<String, Pose> then = rig.lab().truePoses();
            rig.lab().time().sleep(2);
            assertThat(rig.lab().truePoses()).isEqualTo(then);
        }
    }

    @ParameterizedTest(name = "of type {0}")
    @ValueSource(strings = {"aibo", "pioneer", "hemisson"})
    void aRobotThatWasOnlyJustAddedCanBeAGuard(String type) throws InterruptedException {
        try (LabRig rig = LabRig.noisy(1)) {
            rig.add(type);
            rig.say("1 act Guard");
            rig.lab().time().sleep(3);
            assertThat(rig.said()).isEmpty();
            assertThat(rig.team().member(1).owner()).isNotNull();
            assertThat(rig.team().isLatched()).isFalse();
        }
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theRaceEndsInTheOrderOfSpeed(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "aibo", new Pose(-1000, 700, 0));
            ActLabs.place(rig, "pioneer", new Pose(-1000, 0, 0));
            ActLabs.place(rig, "hemisson", new Pose(-1000, -700, 0));
            rig.withAllRobots();
            assertThat(rig.run("1 act MajicRace with 2,3"))
                    .containsSubsequence(
                            "1: MajicRace: number 1 is robot 2 (Pioneer)",
                            "1: MajicRace: number 2 is robot 1 (Aibo)",
                            "1: MajicRace: number 3 is robot 3 (Hemisson)");
            assertThat(rig.lab().truePoses().values()).allMatch(pose -> pose.xMm() > -200 && pose.xMm() < 200);
        }
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void aFollowerInAConvoyKeepsItsDistance(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = convoy(lab)) {
            Pose start = rig.truePose("aibo");
            rig.lab().time().sleep(12);
            Map<String, List<Pose>> ways = ActLabs.watch(rig, 25);

            assertThat(apart(ways, "aibo", "pioneer")).allMatch(mm -> mm > 830 && mm < 1030);
            assertThat(rig.truePose("aibo").distanceMm(start)).isGreaterThan(2000);
        }
    }

    static Stream<Named<Supplier<LabRig>>> labsWithTwoPioneers() {
        return ActLabs.labsWithTwoPioneers();
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labsWithTwoPioneers")
    void allFollowersInAConvoyKeepTheirDistance(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "hemisson", new Pose(0, -1200, 0));
            ActLabs.place(rig, "aibo", new Pose(-500, 0, 0));
            ActLabs.place(rig, "pioneer", new Pose(-1400, 0, 0));
            ActLabs.place(rig, "pioneer2", new Pose(-2400, 0, 0));
            List.of("aibo", "pioneer", "pioneer2").forEach(rig::add);
            rig.say("1 act Convoy with 2,3");
            rig.lab().time().sleep(12);
            Map<String, List<Pose>> ways = ActLabs.watch(rig, 20);

            assertThat(apart(ways, "aibo", "pioneer")).allMatch(mm -> mm > 830 && mm < 1030);
            assertThat(rig.said()).noneMatch(line -> line.contains("sees nobody"));
            assertThat(apart(ways, "pioneer", "pioneer2")).allMatch(mm -> mm > 1000 && mm < 1150);
            assertThat(ActLabs.bumps(rig).values()).containsOnly(0);
        }
    }

    /** Returns the distances between the middles of two robots, mm, each second. */
    private static List<Double> apart(Map<String, List<Pose>> ways, String ahead, String behind) {
        List<Pose> after = ways.get(behind);
        return IntStream.range(0, after.size())
                .mapToObj(second -> ways.get(ahead).get(second).distanceMm(after.get(second)))
                .toList();
    }

    @Test
    void aFollowerWithTooShortASensorRangeIsRefusedAndNoRobotMoves() throws InterruptedException {
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            Map<String, Pose> before = rig.lab().truePoses();
            assertThat(rig.run("2 act Convoy with 1,3"))
                    .containsExactly(
                            "2 act Convoy with 1,3: failed: robot 3 (Hemisson) sees too little: its distance is 40 mm, and"
                                    + " a follower needs 100 mm");
            assertThat(rig.lab().truePoses()).isEqualTo(before);
        }
    }

    /**
     * Creates a lab with a dog ahead of a Pioneer, 900 mm between their middles and some 450 mm between their hulls.
     */
    private static LabRig convoy(Supplier<LabRig> lab) {
        LabRig rig = lab.get();
        ActLabs.place(rig, "aibo", new Pose(-1000, 0, 0));
        ActLabs.place(rig, "pioneer", new Pose(-1900, 0, 0));
        rig.add("aibo");
        rig.add("pioneer");
        rig.say("1 act Convoy with 2");
        return rig;
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void aConvoyWaitsForAFollowerThatLostTheLeader(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = convoy(lab)) {
            rig.lab().time().sleep(12);
            ActLabs.place(rig, "aibo", new Pose(0, 2500, 0));
            ActLabs.awaitSaid(rig, "1: Convoy: robot 2 (Pioneer) sees no robot ahead");
            rig.lab().time().sleep(1);
            Map<String, Pose> then = rig.lab().truePoses();
            rig.lab().time().sleep(3);
            assertThat(rig.lab().truePoses()).isEqualTo(then);
            assertThat(rig.run("2 stop")).contains("1 act Convoy with 2: stopped");
        }
    }
}
