package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import majic.ros.graph.RosGraph;
import org.junit.jupiter.api.Test;

/** The answers of rosapi in a session that was recorded with a real server. */
class RecordedGraphTest {
    private static final String FILE = "graph/rosapi-noetic.txt";

    /** The recorded answer to each question: the service and the argument. */
    private final Map<String, String> answers = new LinkedHashMap<>();

    private void read() throws IOException {
        try (InputStream file = Objects.requireNonNull(RecordedGraphTest.class.getResourceAsStream(FILE))) {
            String question = "";
            for (String line : new String(file.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .toList()) {
                if (line.startsWith("-> ")) {
                    question = question(ScriptedRos.parse(line.substring(3)));
                } else if (line.startsWith("<- ")) {
                    answers.put(question, line.substring(3));
                }
            }
        }
    }

    private static String question(JsonNode call) {
        JsonNode arguments = call.path("args");
        return call.path("service").asText() + " "
                + arguments.path("name").asText(arguments.path("topic").asText());
    }

    /** The robot had no description; what a parameter is answered that is not there was recorded for another name. */
    private String answer(JsonNode call) {
        String recorded = answers.get(question(call).replace("/robot_description", "/not_there"));
        assertThat(recorded).as("the recorded answer to %s", call).isNotNull();
        ObjectNode answer = (ObjectNode) ScriptedRos.parse(recorded);
        answer.set("id", call.path("id"));
        return answer.toString();
    }

    @Test
    void theRecordedServerIsUnderstood() throws IOException {
        read();
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.wholeAnswer = this::answer;
            robot.bot().connect();

            assertThat(robot.bot().introduction())
                    .contains("TurtleBot3 fake Burger", "ROS 1 noetic", "/cmd_vel with /odom");
            RosGraph graph = robot.bot().session().graph();
            assertThat(graph.topics()).hasSize(13).containsEntry("/scan", "sensor_msgs/LaserScan");
            assertThat(graph.nodes()).contains("/turtlebot3_fake_node", "/rosapi");
        }
    }
}
