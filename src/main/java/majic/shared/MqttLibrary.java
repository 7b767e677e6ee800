package majic.shared;

import java.util.List;
import majic.bot.BotException;

/** Whether the libraries for MQTT and JSON are there, which are optional for programs that embed robots. */
final class MqttLibrary {
    private static final List<String> CLASSES =
            List.of("com.hivemq.client.mqtt.mqtt5.Mqtt5Client", "com.fasterxml.jackson.databind.ObjectMapper");

    private MqttLibrary() {}

    /**
     * Refuses to go on without the libraries.
     *
     * @throws BotException if one is missing; the message names both
     */
    static void require() {
        for (String name : CLASSES) {
            try {
                Class.forName(name, false, MqttLibrary.class.getClassLoader());
            } catch (ClassNotFoundException e) {
                throw new BotException(
                        "robots of other desks need the libraries hivemq-mqtt-client and jackson-databind: add both to the"
                                + " class path",
                        e);
            }
        }
    }
}
