package majic.shared.vda5050;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.time.temporal.ChronoUnit;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;

/**
 * The topics of one vehicle and the header of its messages, with a number that counts those of each topic. Thread-safe.
 */
final class VehicleHeader {
    private static final String VERSION = "2.0.0";
    private static final String MANUFACTURER = "MAJIC";
    private static final long UINT32 = 1L << 32;

    private final String prefix;
    private final String serialNumber;
    private final Clock clock;
    private final Map<Topic, Long> numbers = new EnumMap<>(Topic.class);

    /** The topics of a vehicle. */
    enum Topic {
        /** Whether the vehicle is there; retained. */
        CONNECTION,
        /** What it does. */
        STATE,
        /** What it is; retained. */
        FACTSHEET,
        /** Actions that fleet tools demand at once. */
        INSTANT_ACTIONS,
        /** Orders, none of which is accepted. */
        ORDER;

        private String level() {
            return this == INSTANT_ACTIONS ? "instantActions" : name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * @param site the levels before those of the specification
     * @param serialNumber unique among the vehicles of the site
     * @param clock the time of day for the messages
     */
    VehicleHeader(String site, String serialNumber, Clock clock) {
        this.prefix = site + "/uagv/v2/" + MANUFACTURER + "/" + serialNumber + "/";
        this.serialNumber = serialNumber;
        this.clock = clock;
    }

    String topic(Topic topic) {
        return prefix + topic.level();
    }

    /** The beginning of a message. */
    synchronized ObjectNode begin(Topic topic) {
        long number = numbers.merge(topic, 1L, Long::sum);
        return JsonNodeFactory.instance
                .objectNode()
                .put("headerId", (number - 1) % UINT32)
                .put("timestamp", clock.instant().truncatedTo(ChronoUnit.MILLIS).toString())
                .put("version", VERSION)
                .put("manufacturer", MANUFACTURER)
                .put("serialNumber", serialNumber);
    }

    /** The specification demands quality of service 1 for the connection, and 0 for everything else. */
    BrokerMessage message(Topic topic, ObjectNode json) {
        Quality quality = topic == Topic.CONNECTION ? Quality.AT_LEAST_ONCE : Quality.AT_MOST_ONCE;
        BrokerMessage message =
                BrokerMessage.json(topic(topic), json.toString().getBytes(StandardCharsets.UTF_8), quality);
        return topic == Topic.STATE ? message : message.retain();
    }

    /** The message that reports whether the vehicle is there, in the words of the specification. */
    BrokerMessage connection(String state) {
        return message(Topic.CONNECTION, begin(Topic.CONNECTION).put("connectionState", state));
    }
}
