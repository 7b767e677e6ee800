package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;

/** The parts from which the robot's messages are made; fields that are left out mean zero. */
final class Messages {
    private Messages() {}

    static ObjectNode empty() {
        return JsonNodeFactory.instance.objectNode();
    }

    static ArrayNode list() {
        return JsonNodeFactory.instance.arrayNode();
    }

    /** A message with a header; the stamp in ns since 1970. */
    static ObjectNode stamped(long nanos, String frame) {
        ObjectNode message = empty();
        message.putObject("header").put("stamp", nanos).put("frame_id", frame);
        return message;
    }

    static ObjectNode vector(double x, double y, double z) {
        return empty().put("x", x).put("y", y).put("z", z);
    }

    /** A turn about the vertical axis, rad counter-clockwise. */
    static ObjectNode rotation(double yaw) {
        return vector(0, 0, Math.sin(yaw / 2)).put("w", Math.cos(yaw / 2));
    }

    static ObjectNode pose(WheelOdometry at) {
        ObjectNode pose = empty();
        pose.set("position", vector(at.x(), at.y(), 0));
        pose.set("orientation", rotation(at.yaw()));
        return pose;
    }

    static ObjectNode twist(double metresPerSec, double radPerSec) {
        ObjectNode twist = empty();
        twist.set("linear", vector(metresPerSec, 0, 0));
        twist.set("angular", vector(0, 0, radPerSec));
        return twist;
    }

    static ArrayNode numbers(double... numbers) {
        ArrayNode array = list();
        for (double number : numbers) {
            array.add(number);
        }
        return array;
    }

    /** A square matrix with this diagonal, row by row. */
    static ArrayNode diagonal(double... diagonal) {
        ArrayNode matrix = list();
        for (int i = 0; i < diagonal.length * diagonal.length; i++) {
            matrix.add(i % (diagonal.length + 1) == 0 ? diagonal[i / (diagonal.length + 1)] : 0.0);
        }
        return matrix;
    }
}
