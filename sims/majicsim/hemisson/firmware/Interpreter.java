package majicsim.hemisson.firmware;

import majicsim.hemisson.uart.Reply;

/** Executes the command that has just ended in the buffer, as one maker's firmware does. */
public interface Interpreter {
    /** The greeting after power-up and reset, without the line with the running mode. */
    String greeting();

    /** Executes the command. */
    Reply carryOut();
}
