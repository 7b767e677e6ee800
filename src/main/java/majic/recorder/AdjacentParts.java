package majic.recorder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The files before and after one of a recording that consists of several. Immutable.
 *
 * @param previous the file with the nearest lower number of a part; empty if there is none in the folder
 * @param next the file with the nearest higher number; empty if there is none
 */
public record AdjacentParts(Optional<Path> previous, Optional<Path> next) {
    /**
     * Finds them among the recordings in the folder of a file, whatever their names. Blocks.
     *
     * @param file a file of a recording
     * @param head what it says about itself
     * @return only files that can be read
     * @throws IOException if the folder cannot be read
     */
    public static AdjacentParts of(Path file, RecordingHead head) throws IOException {
        TreeMap<Integer, Path> parts = new TreeMap<>();
        try (Stream<Path> all = Files.list(file.toAbsolutePath().getParent())) {
            all.filter(RecordingFolder::isRecording)
                    .forEach(other -> part(other, head).ifPresent(number -> parts.put(number, other)));
        }
        return new AdjacentParts(file(parts.lowerEntry(head.part())), file(parts.higherEntry(head.part())));
    }

    /** Returns the number of a file among the parts of a recording; empty if it belongs to another one. */
    private static Optional<Integer> part(Path file, RecordingHead head) {
        try {
            RecordingHead other = RecordingHead.read(file);
            return other.begin().equals(head.begin()) ? Optional.of(other.part()) : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private static Optional<Path> file(Map.@Nullable Entry<Integer, Path> part) {
        return Optional.ofNullable(part).map(Map.Entry::getValue);
    }
}
