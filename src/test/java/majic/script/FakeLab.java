package majic.script;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.time.TimeSource;

/** A lab with the clock of the test and one robot of each type, at its start pose. */
record FakeLab(TimeSource time) implements LabAccess {
    @Override
    public long seed() {
        return 1;
    }

    @Override
    public List<String> robots() {
        return List.of("aibo", "pioneer");
    }

    @Override
    public Optional<BotAddress> address(String type) {
        return robots().contains(type) ? Optional.of(new BotAddress(type, "//lab")) : Optional.empty();
    }

    @Override
    public Map<String, Pose> truePoses() {
        return Map.of("aibo", new Pose(1234.4, -0.2, -0.01));
    }

    @Override
    public Map<String, Integer> bumps() {
        return Map.of("aibo", 2);
    }

    /** There is a wall where x is negative. */
    @Override
    public void place(String robot, Pose pose) {
        if (pose.xMm() < 0) {
            throw new BotException("a wall or another robot is there");
        }
    }

    @Override
    public List<Wall> walls() {
        return List.of();
    }
}
