package majicsim.aibo.urbi.run;

import majicsim.aibo.urbi.value.Value;

/** A client's connection, or the server's own, as seen by its running commands. */
public interface Connection {
    /** The server to which it belongs. */
    Server server();

    /** Its name. */
    String id();

    /** Its name and the address of its client. */
    String describe();

    /** The context of a command that the client sends. */
    Context context();

    /** Answers with a value; a binary has no line end behind its bytes. */
    void reply(String tag, Value value);

    /** Sends one line. */
    void send(String tag, String body);

    /** Reports that a command was refused, once in a pass of the server. */
    void overloaded();

    /** All commands that run in it. */
    Task commands();

    /** Adds a command that runs in parallel from the next cycle on. */
    void adopt(Task task);

    /** Ends all commands that run in it. */
    void clear();

    /** Closes it from the server's side, after everything was sent. */
    void quit();
}
