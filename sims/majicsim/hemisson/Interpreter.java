package majicsim.hemisson;

import majicsim.hemisson.uart.Reply;

/** What a firmware makes of the command that has just ended in its buffer. */
interface Interpreter {
    /** What it says after power-up and reset, without the line that tells the running mode. */
    String greeting();

    /** Carries the command out. */
    Reply carryOut();
}
