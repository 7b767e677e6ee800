package majic.pioneer.session;

import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.RangeScan;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.LaserChunk;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;
import org.jspecify.annotations.Nullable;

/**
 * The connection of one session with a robot, over a link or through a library. What is above it does not depend on
 * which of them is used.
 */
public interface PioneerConnection {
    /** Is notified of what the robot reports, on one thread of the connection. Must not wait for anything. */
    interface Listener {
        /** The robot has been identified: reports follow. Called once, on the thread that opens the connection. */
        void identified(PioneerIdentity identity);

        /** A SIP came. */
        void reported(Sip sip);

        /** Another report came. */
        void reported(Report report);

        /** A part of a scan by the laser of a simulator came. */
        void reported(LaserChunk chunk);

        /**
         * A scan of a laser came.
         *
         * @param scan its odometry is relative to the pose of the robot in the last SIP
         */
        void reported(RangeScan scan);

        /** Something that the user should know has happened; on any thread. */
        void notice(String message);

        /** The robot's configuration came, as far as the connection can read it. */
        void configured(Config config);

        /** The connection has ended; may be called more than once, and before the robot is identified. */
        void ended(LinkLost cause);
    }

    /**
     * Connects; moves nothing and switches no motors on. Returns when the robot is identified, a SIP has come, and the
     * configuration, if the robot sends one. After an exception {@link #close} is necessary.
     *
     * @throws BotException if there is no Pioneer, or it sends no SIP; the message says why
     */
    void open(Listener listener);

    /** What carries the commands. */
    RobotLine line();

    /** The address as a user would type it. */
    String address();

    /** Whether it converts the robot's counts by itself, so that the scale of an unknown model is known. */
    default boolean scales() {
        return false;
    }

    /** Why a value is unknown that does not come over this connection, as half a sentence. */
    default String missing() {
        return "this robot does not tell";
    }

    /** Counts of packets and damaged bytes; null if they are not known. */
    @Nullable
    PacketCounts counts();

    /** Ends the session of a stopped robot, and the connection; takes little over a second at most. */
    void close();
}
