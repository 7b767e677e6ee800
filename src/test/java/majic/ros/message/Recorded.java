package majic.ros.message;

import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/**
 * Messages of a recorded session with a rosbridge server on ROS 1 Noetic and the simulated base turtlebot3_fake, one of
 * each topic.
 */
final class Recorded {
    private static final ObjectMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();

    private Recorded() {}

    /** Returns the content of the message of a topic. */
    static JsonNode message(String topic) {
        try (InputStream file = Recorded.class.getResourceAsStream("turtlebot3-fake.txt")) {
            String text = new String(Objects.requireNonNull(file).readAllBytes(), StandardCharsets.UTF_8);
            for (String line : text.lines().toList()) {
                JsonNode published = JSON.readTree(line);
                if (published.path("topic").asText().equals(topic)) {
                    return published.path("msg");
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        throw new IllegalArgumentException("no message of " + topic + " was recorded");
    }

    /** Parses JSON, in which single quotes may stand for double ones. */
    static JsonNode json(String text) {
        try {
            return JSON.readTree(text.replace('\'', '"'));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
