package majicsim.hemisson.firmware;

import majicsim.hemisson.uart.Reply;

/** The commands of one module in the RoadNarrows dialect. */
interface ModuleCommandSet {
    /** Executes one; the answer is what follows the repeated command, with its comma and without its line end. */
    Reply answer(char command, String argument) throws ErrorReplyException;
}
