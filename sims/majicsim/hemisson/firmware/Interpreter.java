package majicsim.hemisson.firmware;

import majicsim.hemisson.uart.Reply;

/** What a firmware makes of the command that has just ended in its buffer. */
public interface Interpreter {
    /** What it says after power-up and reset, without the line that tells the running mode. */
    String greeting();

    /** Carries the command out. */
    Reply carryOut();
}
