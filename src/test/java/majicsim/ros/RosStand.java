package majicsim.ros;

import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import majicsim.Lab;
import majicsim.LabOptions;
import majicsim.ros.options.RosOptions;
import majicsim.world.Pose;

/** A lab without noise with a ROS robot, stepped by the test, and clients of its bridge. */
final class RosStand implements AutoCloseable {
    private static final ObjectMapper MAPPER = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();
    private static final int MOST_STEPS = 100_000;

    private final Lab lab;

    RosStand(String model) throws IOException {
        lab = Lab.open(LabOptions.exactOnFreePorts().withRos(RosOptions.parse(model)));
    }

    Lab lab() {
        return lab;
    }

    String address() {
        return lab.addresses().get("ros").replaceFirst("/.*", "");
    }

    Pose pose() {
        return lab.truePoses().get("ros");
    }

    /** Lets lab time pass. */
    void pass(double seconds) {
        for (long end = lab.nanos() + Math.round(seconds * 1e9); lab.nanos() < end; ) {
            lab.step();
        }
    }

    Client client() throws IOException {
        return new Client();
    }

    static JsonNode json(String text) throws IOException {
        return MAPPER.readTree(text);
    }

    @Override
    public void close() {
        lab.close();
    }

    /** A client of the bridge. */
    final class Client implements AutoCloseable {
        private final RawWebSocket socket;
        private final List<JsonNode> received = new ArrayList<>();
        private final List<String> texts = new ArrayList<>();
        private int calls;

        private Client() throws IOException {
            socket = RawWebSocket.open(address());
        }

        RawWebSocket socket() {
            return socket;
        }

        /** How many bytes it has sent. */
        long sentBytes() {
            return socket.sentBytes();
        }

        /** Sends an object; single quotes stand for double ones. */
        void send(String quoted) throws IOException {
            socket.sendText(quoted.replace('\'', '"'));
        }

        /** Sends an object and waits until the bridge has dealt with it. */
        void sendAll(String... quoted) throws IOException {
            for (String one : quoted) {
                send(one);
            }
            settle();
        }

        /** Waits until the bridge has dealt with all that was sent; collects what came meanwhile. */
        void settle() throws IOException {
            calls++;
            String id = "settle" + calls;
            send("{'op':'call_service','id':'" + id + "','service':'/rosapi/get_time'}");
            while (!read().path("id").asText().equals(id)) {
                received.add(last());
            }
            texts.remove(texts.size() - 1);
        }

        private JsonNode lastRead = MAPPER.missingNode();

        private JsonNode last() {
            return lastRead;
        }

        private JsonNode read() throws IOException {
            String text = socket.read().text();
            texts.add(text);
            lastRead = json(text);
            return lastRead;
        }

        /** Calls a service; returns the whole response. */
        JsonNode call(String service, String args) throws IOException {
            calls++;
            String id = "call" + calls;
            send("{'op':'call_service','id':'" + id + "','service':'" + service + "','args':" + args + "}");
            while (!read().path("id").asText().equals(id)) {
                received.add(last());
            }
            return last();
        }

        /** Calls a service without arguments; returns what it answered. */
        JsonNode values(String service) throws IOException {
            return call(service, "{}").path("values");
        }

        /** Steps the lab until a message comes that fits; earlier ones are passed over. */
        JsonNode await(Predicate<JsonNode> wanted) throws IOException {
            for (int i = 0; i < MOST_STEPS; i++) {
                while (!received.isEmpty()) {
                    JsonNode next = received.remove(0);
                    if (wanted.test(next)) {
                        return next;
                    }
                }
                lab.step();
                settle();
            }
            throw new IOException("nothing came that fits");
        }

        /** Steps the lab until the topic is published; returns the message. */
        JsonNode message(String topic) throws IOException {
            return await(object -> object.path("topic").asText().equals(topic)).path("msg");
        }

        /** Returns and forgets all that came and was not looked at. */
        List<JsonNode> taken() throws IOException {
            settle();
            List<JsonNode> taken = List.copyOf(received);
            received.clear();
            return taken;
        }

        /** The texts of all messages so far. */
        List<String> texts() {
            return texts;
        }

        void drive(double metresPerSec, double radPerSec) throws IOException {
            sendAll("{'op':'publish','topic':'/cmd_vel','msg':{'linear':{'x':" + metresPerSec + "},'angular':{'z':"
                    + radPerSec + "}}}");
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }
}
