package majic.recorder;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;

/**
 * What a list of recordings shows of a file. Immutable.
 *
 * @param lengthS how much time it covers, seconds
 * @param robots the robots in it, in the order of their numbers; of several with one number, the last
 */
public record RecordingSummary(double lengthS, List<RecordedRobot> robots) {
    /** Keeps a copy of the list. */
    public RecordingSummary {
        robots = List.copyOf(robots);
    }

    /**
     * Reads a whole file, without keeping its content. Blocks, for about a second for a file of 15 MB.
     *
     * @param file a file of a recording
     * @return its length and robots
     * @throws IOException if it cannot be read, or is no recording; the message says why
     */
    public static RecordingSummary read(Path file) throws IOException {
        Collector content = new Collector();
        RecordingHead head = RecordingReader.read(file, content);
        return new RecordingSummary(Math.max(0, content.endS - head.beginS()), List.copyOf(content.robots.values()));
    }

    private static final class Collector implements RecordingSink {
        private final TreeMap<Integer, RecordedRobot> robots = new TreeMap<>();
        private double endS;

        @Override
        public void time(double seconds) {
            endS = seconds;
        }

        @Override
        public void robot(RecordedRobot robot) {
            robots.put(robot.number(), robot);
        }
    }
}
