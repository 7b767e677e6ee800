package majic.gui;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.time.TimeSource;

/** A lab with one toy in a square room, which can be placed anywhere. */
public final class ToyLab implements LabAccess {
    public static final Pose FIRST_PLACE = new Pose(1000, 500, 90);

    private volatile Pose truth = FIRST_PLACE;

    public void place(Pose pose) {
        truth = pose;
    }

    @Override
    public long seed() {
        return 1;
    }

    @Override
    public void place(String robot, Pose pose) {
        truth = pose;
    }

    @Override
    public Map<String, Integer> bumps() {
        return Map.of("toy", 0);
    }

    @Override
    public List<String> robots() {
        return List.of("toy");
    }

    @Override
    public Optional<BotAddress> address(String type) {
        return type.equals("toy") ? Optional.of(BotAddress.parse("toy://in-the-lab:1")) : Optional.empty();
    }

    @Override
    public TimeSource time() {
        return TimeSource.system();
    }

    @Override
    public Map<String, Pose> truePoses() {
        return Map.of("toy", truth);
    }

    @Override
    public List<Wall> walls() {
        return List.of(
                new Wall(0, 0, 4000, 0),
                new Wall(4000, 0, 4000, 3000),
                new Wall(4000, 3000, 0, 3000),
                new Wall(0, 3000, 0, 0));
    }
}
