package majic.ros.message;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.Optional;

/** The two message types with which bases are driven. */
public enum VelocityForm {
    /** {@code geometry_msgs/Twist}: ROS 1, and most bases on ROS 2. */
    TWIST("Twist") {
        @Override
        public ObjectNode message(double mmPerSec, double degPerSec) {
            return twist(mmPerSec, degPerSec);
        }
    },
    /**
     * {@code geometry_msgs/TwistStamped}: newer bases on ROS 2. The header has no stamp, so that rosbridge puts in the
     * robot's own time: a stamp of this computer might be older than the base accepts.
     */
    TWIST_STAMPED("TwistStamped") {
        @Override
        public ObjectNode message(double mmPerSec, double degPerSec) {
            ObjectNode stamped = JsonNodeFactory.instance.objectNode();
            stamped.putObject("header");
            stamped.set("twist", twist(mmPerSec, degPerSec));
            return stamped;
        }
    };

    private final String shortName;

    VelocityForm(String shortName) {
        this.shortName = shortName;
    }

    /**
     * Finds the form of a topic.
     *
     * @param type the type of the topic, in the form of ROS 1 or of ROS 2
     * @return empty if topics of this type drive no base
     */
    public static Optional<VelocityForm> ofType(String type) {
        return Arrays.stream(values())
                .filter(form -> type.matches("geometry_msgs/(msg/)?" + form.shortName))
                .findFirst();
    }

    /**
     * Makes the message for a velocity. Every part is given, in finite numbers.
     *
     * @param mmPerSec ahead positive, finite
     * @param degPerSec counterclockwise positive, finite
     * @return the content of a message of this type
     * @throws IllegalArgumentException if a number is not finite: the bridge would pass it on to the motors
     */
    public abstract ObjectNode message(double mmPerSec, double degPerSec);

    private static ObjectNode twist(double mmPerSec, double degPerSec) {
        if (!Double.isFinite(mmPerSec) || !Double.isFinite(degPerSec)) {
            throw new IllegalArgumentException("a velocity is finite: " + mmPerSec + ", " + degPerSec);
        }
        ObjectNode twist = JsonNodeFactory.instance.objectNode();
        putVector(twist.putObject("linear"), RosUnits.metres(mmPerSec), 0);
        putVector(twist.putObject("angular"), 0, Math.toRadians(degPerSec));
        return twist;
    }

    /** Adding zero turns −0.0 into 0.0. */
    private static void putVector(ObjectNode vector, double x, double z) {
        vector.put("x", x + 0.0).put("y", 0.0).put("z", z + 0.0);
    }
}
