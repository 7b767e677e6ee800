package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The fixed frames of a robot and where each is in its parent, as {@code /tf_static} gives them in one or several
 * messages. Immutable.
 */
public final class FrameTree {
    /** No frames. */
    public static final FrameTree EMPTY = new FrameTree(Map.of());

    /** More links than any robot has; a circle of frames ends there. */
    private static final int DEEPEST = 100;

    private final Map<String, Mounting> mountings;

    private FrameTree(Map<String, Mounting> mountings) {
        this.mountings = Collections.unmodifiableMap(mountings);
    }

    /** A frame in its parent. */
    private record Mounting(String parent, FrameTransform transform) {}

    /**
     * Adds the frames of a message; a frame that is there already is replaced.
     *
     * @param message the content of a {@code tf2_msgs/TFMessage}
     * @return a new tree
     * @throws UnusableMessage if a transform is not given in finite numbers, or the message has no list of them
     */
    public FrameTree with(JsonNode message) {
        Map<String, Mounting> more = new HashMap<>(mountings);
        for (JsonNode frame : Fields.list(message, "transforms")) {
            Vector originM = Vector.from(frame, "transform.translation")
                    .orElseThrow(() -> new UnusableMessage("transform.translation has to be three finite numbers"));
            more.put(
                    Fields.frame(frame, "child_frame_id"),
                    new Mounting(
                            Fields.frame(frame, "header.frame_id"),
                            new FrameTransform(
                                    originM.times(RosUnits.mm(1)), Orientation.from(frame, "transform.rotation"))));
        }
        return new FrameTree(more);
    }

    /**
     * Finds where a frame is in another one, whichever of them is nearer to the root.
     *
     * @param inner the frame of a sensor
     * @param outer the frame of the robot
     * @return empty if the tree does not connect them
     */
    public Optional<FrameTransform> find(String inner, String outer) {
        Map<String, FrameTransform> above = ancestors(inner);
        for (Map.Entry<String, FrameTransform> common : ancestors(outer).entrySet()) {
            FrameTransform innerInCommon = above.get(common.getKey());
            if (innerInCommon != null) {
                return Optional.of(common.getValue().inverse().times(innerInCommon));
            }
        }
        return Optional.empty();
    }

    /** Where a frame is in itself, in its parent, in the parent of that, and so on. */
    private Map<String, FrameTransform> ancestors(String frame) {
        Map<String, FrameTransform> ancestors = new LinkedHashMap<>();
        ancestors.put(frame, FrameTransform.NONE);
        FrameTransform inAncestor = FrameTransform.NONE;
        Mounting mounting = mountings.get(frame);
        for (int depth = 0; mounting != null && depth < DEEPEST; depth++) {
            inAncestor = mounting.transform().times(inAncestor);
            ancestors.putIfAbsent(mounting.parent(), inAncestor);
            mounting = mountings.get(mounting.parent());
        }
        return ancestors;
    }
}
