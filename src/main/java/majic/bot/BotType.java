package majic.bot;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.JComponent;
import majic.environment.BotEnvironment;
import majic.text.Advice;
import org.jspecify.annotations.Nullable;

/**
 * A make of robot: how it is called, how it is reached, how its driver is made. Implementations are named in
 * {@code META-INF/services/majic.bot.BotType} of this jar or of one in the user's plug-ins folder, have a public
 * constructor without arguments, and start nothing in it.
 */
public interface BotType {
    /** The kind of connection to a robot of a type; the Add dialog asks accordingly. */
    enum Reach {
        /** By host and TCP port. */
        TCP,
        /** By a serial port of this machine. */
        SERIAL
    }

    /**
     * The display of a robot that is fed from a recording. All methods but {@link #component()} are called on one
     * thread, which is not the event dispatch thread; the component refreshes itself as that of a connected robot does.
     */
    interface ReplayDisplay {
        /**
         * Returns the display.
         *
         * @return the same component at every call; on the event dispatch thread
         */
        JComponent component();

        /** Forgets what was shown, because the replay continues at another time. */
        void reset();

        /**
         * Shows a recorded state. Called in the order of the recording, also for states too short to be seen.
         *
         * @param state what {@link MajicBot#displayState()} returned; names may be missing
         * @param nanos the time of the recording
         */
        void show(Map<String, String> state, long nanos);

        /**
         * Shows a picture of the camera.
         *
         * @param jpeg a JPEG file
         */
        default void showPicture(byte[] jpeg) {}
    }

    /**
     * Returns the word for this type in addresses and in MAJIC Script.
     *
     * @return lower-case letters: {@code pioneer}
     */
    String name();

    /**
     * Returns further schemes of addresses that mean this type, such as one for an encrypted connection.
     *
     * @return lower-case letters
     */
    default List<String> otherSchemes() {
        return List.of();
    }

    /**
     * Returns whether a scheme of an address means this type.
     *
     * @param scheme case is ignored
     * @return true for the name and for {@link #otherSchemes()}
     */
    default boolean isMeantBy(String scheme) {
        return name().equalsIgnoreCase(scheme) || otherSchemes().contains(scheme.toLowerCase(Locale.ROOT));
    }

    /**
     * Returns whether an address may name one of several robots behind its host and port, as {@code //host:9090/robot1}
     * does.
     *
     * @return whether the Add dialog asks for it
     */
    default boolean isOneOfSeveral() {
        return false;
    }

    /**
     * Returns whether {@link #robotsAt} finds robots.
     *
     * @return true for robots that are reached through a broker, which has a list of them
     */
    default boolean canListRobots() {
        return false;
    }

    /**
     * Finds the robots behind an address that stands for several. Blocks for some seconds.
     *
     * @param address with a slash at its end: {@code mqtt://broker/lab/}
     * @param environment the clock and settings to use
     * @return what each robot is, by its address; empty if there are none
     * @throws BotException if the address is wrong, or nothing answers there; the message says what would be right
     */
    default Map<String, String> robotsAt(BotAddress address, BotEnvironment environment) {
        return Map.of();
    }

    /**
     * Finds the robots that send to this computer without being asked, at the usual port. Blocks for some seconds.
     *
     * @param environment the clock and settings to use
     * @return what each robot is, by its address; empty if there are none
     * @throws BotException if the port cannot be opened
     */
    default Map<String, String> robotsSending(BotEnvironment environment) {
        return Map.of();
    }

    /**
     * Returns the short name for users.
     *
     * @return for instance {@code Pioneer}
     */
    String label();

    /**
     * Maker and model.
     *
     * @return for instance {@code MobileRobots Pioneer}
     */
    String make();

    /**
     * Returns the kinds of connection to a robot of this type, the usual one first.
     *
     * @return one or both
     */
    List<Reach> reaches();

    /**
     * Returns the usual TCP port of addresses with a scheme, which the Add dialog offers.
     *
     * @param scheme one that {@linkplain #isMeantBy means} this type, in lower case
     * @return 1 to 65535; 0 if there is no usual one
     */
    int defaultPort(String scheme);

    /**
     * Makes the driver for a robot at an address, without touching the robot.
     *
     * @param address its scheme {@linkplain #isMeantBy means} this type; the rest, such as {@code //host:8101},
     *     {@code COM3} or {@code tcp://host:4001}, is not checked yet. A library in it is one of {@link #libraries()}
     * @param environment the clock and settings to use
     * @return the driver, not connected
     * @throws BotException if the address is invalid, or the library it names is not installed; the message says what
     *     would be right
     */
    MajicBot create(BotAddress address, BotEnvironment environment);

    /**
     * Returns the makers' libraries by which a robot of this type can be driven instead of by the driver's own client.
     *
     * @return their names in addresses: {@code aria} for {@code pioneer+aria://10.0.0.5}
     */
    default List<String> libraries() {
        return List.of();
    }

    /**
     * Returns the name of the type that makes the display of a recorded robot of this type.
     *
     * @return {@link #name()} unless overridden; another for robots that are displayed differently from others of that
     *     name
     */
    default String replayedBy() {
        return name();
    }

    /**
     * Makes the display of a recorded robot. Called on the event dispatch thread.
     *
     * @param recorded gives the recorded parameters and states, and refuses every command
     * @return a display that is fed from the recording; null for a table of the parameters
     */
    default @Nullable ReplayDisplay replay(MajicBot recorded) {
        return null;
    }

    /**
     * Returns what to try when nothing answers, for users next to the robot.
     *
     * @return one or two sentences
     */
    String advice();

    /**
     * Returns the advice behind what went wrong, as whole sentences; none behind a question, which asks what to look
     * at.
     *
     * @param problem what went wrong, with or without a full stop
     * @return both in one line
     */
    default String adviceAfter(String problem) {
        return Advice.after(problem, advice());
    }
}
