package majicsim.aibo.urbi.run;

import java.util.List;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;

/** The URBI server as seen by its running commands: its time, its memory and its connections. */
public interface Server {
    /** The cycle of the ERS-7 (URBI sheet, section 3). */
    double CYCLE_MS = 32;

    /** Lab time since the robot was made, ms. */
    double nowMs();

    /** The time in front of each reply, ms. */
    double timestampMs();

    /** The number of the present run through the commands, from 0: a cycle, or bytes that a client has just sent. */
    long pass();

    /** What programs have given names to. */
    Memory memory();

    /** The functions, to which the hardware adds its own. */
    Functions functions();

    /** The tags that are blocked or frozen. */
    Tags tags();

    /** The limits of programs. */
    Budget budget();

    /** All connections, the server's own first. */
    List<Connection> connections();

    /** The connections of a name: the sender's own for no name, otherwise all, other, or one by its name. */
    List<Connection> recipients(Connection sender, String named) throws Failure;

    /** Returns the task of a command, not started. */
    Task start(Context context, Statement statement);

    /** Resets the server from the next cycle on. */
    void reset();
}
