package majicsim.hemisson.firmware;

import majicsim.hemisson.uart.Reply;

/** What a firmware makes of the command that has just ended in its buffer. */
public interface Interpreter {
    /** The greeting after power-up and reset, without the line with the running mode. */
    String greeting();

    /** Carries the command out. */
    Reply carryOut();
}
