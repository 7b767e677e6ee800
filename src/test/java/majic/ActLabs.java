package majic;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import majic.bot.Pose;
import org.junit.jupiter.api.Named;

/** The labs in which every shipped behaviour has to prove itself, and what is measured there. */
final class ActLabs {
    private static final int SEEDS = 5;
    private static final double METRE_MM = 1000;

    private ActLabs() {}

    /** A lab without noise, and five with. */
    static Stream<Named<Supplier<LabRig>>> labs() {
        return Stream.concat(
                Stream.of(Named.of("an exact lab", LabRig::exact)),
                LongStream.rangeClosed(1, SEEDS)
                        .mapToObj(seed -> Named.of("noisy lab " + seed, () -> LabRig.noisy(seed))));
    }

    /** A lab with one robot connected, as number 1. */
    static LabRig with(Supplier<LabRig> lab, String type) {
        LabRig rig = lab.get();
        rig.add(type);
        return rig;
    }

    /** Lets time pass; where the robots were after each second. */
    static Map<String, List<Pose>> watch(LabRig rig, int seconds) throws InterruptedException {
        Map<String, List<Pose>> ways = new LinkedHashMap<>();
        for (int second = 0; second < seconds; second++) {
            rig.lab().time().sleep(1);
            rig.lab()
                    .truePoses()
                    .forEach((robot, pose) -> ways.computeIfAbsent(robot, key -> new ArrayList<>())
                            .add(pose));
        }
        return ways;
    }

    /** In how many squares of a metre a robot has been. */
    static long metresVisited(List<Pose> way) {
        return way.stream()
                .map(pose -> List.of(Math.floor(pose.xMm() / METRE_MM), Math.floor(pose.yMm() / METRE_MM)))
                .distinct()
                .count();
    }

    /** How often each robot drove into something. */
    static Map<String, Integer> bumps(LabRig rig) {
        return rig.lab().simulators().bumps();
    }
}
