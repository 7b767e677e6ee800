package majic.ros;

import majic.bot.BotException;

/** Whether the library for JSON is there, which is optional for programs that embed robots. */
final class JsonLibrary {
    private static final String JSON = "com.fasterxml.jackson.databind.ObjectMapper";
    private static final String CBOR = "com.fasterxml.jackson.dataformat.cbor.databind.CBORMapper";

    private JsonLibrary() {}

    /**
     * Refuses to go on without the library.
     *
     * @throws BotException if it is missing; the message names it
     */
    static void require() {
        try {
            Class.forName(JSON, false, JsonLibrary.class.getClassLoader());
            Class.forName(CBOR, false, JsonLibrary.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new BotException(
                    "robots that speak ROS need the libraries jackson-databind and jackson-dataformat-cbor: add both to the"
                            + " class path",
                    e);
        }
    }
}
