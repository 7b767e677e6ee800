package majic.recorder;

import java.util.HashMap;
import java.util.Map;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.recorder.RecordingFormat.Kind;
import majic.team.BotFactory;
import majic.team.Member;

/** The room of the simulated lab, if there is one, and where the robots are in it. Samples are taken by one thread. */
final class RoomSampler {
    private static final double PERIOD_S = 0.2;

    /** Distance at which robots are placed from each other when their positions are unknown. */
    private static final double GUESSED_APART_MM = 1000;

    private final BotFactory factory;
    private final Map<String, Pose> truths = new HashMap<>();
    private double sampledS = Double.NEGATIVE_INFINITY;

    RoomSampler(BotFactory factory) {
        this.factory = factory;
    }

    /** Describes a robot, with the present place of its own frame in the room. */
    RecordedRobot describe(Member member, double nowS) {
        MajicBot bot = member.bot();
        String inLab = factory.nameInLab(bot).orElse("");
        Pose reported = bot.state().pose();
        Pose origin = factory.lab()
                .filter(lab -> lab.time() == member.time())
                .map(lab -> lab.truePoses().get(inLab))
                .map(truth -> truth.originOf(reported))
                .orElse(new Pose(0, (1 - member.number()) * GUESSED_APART_MM, 0));
        return new RecordedRobot(
                member.number(),
                bot.type().replayedBy(),
                member.label(),
                bot.type().make(),
                bot.profile().bodyMm(),
                bot.profile().estimates(),
                origin,
                inLab,
                nowS);
    }

    /** Adds what does not move, and takes every true pose for changed the next time. */
    void describe(StringBuilder lines) {
        truths.clear();
        sampledS = Double.NEGATIVE_INFINITY;
        factory.lab().ifPresent(lab -> {
            lab.walls().forEach(wall -> lines.append(RecordingFormat.wall(wall)));
            lab.furnishing().tapes().forEach(tape -> lines.append(RecordingFormat.tape(tape)));
            lab.furnishing().lamps().forEach(lamp -> lines.append(RecordingFormat.lamp(lamp)));
        });
    }

    /** Adds the true poses that have changed, at most five times a second. */
    void sample(StringBuilder lines, double nowS) {
        LabAccess lab = factory.lab().orElse(null);
        if (lab == null || nowS - sampledS < PERIOD_S) {
            return;
        }
        sampledS = nowS;
        lab.truePoses().forEach((name, pose) -> {
            if (!pose.equals(truths.put(name, pose))) {
                lines.append(RecordingFormat.change(Kind.TRUTH, 0, name, RecordingFormat.pose(pose)));
            }
        });
    }
}
