/**
 * The language of the simulated dog: the URBI 1.0 kernel with its splitter, lexer, parser and interpreter, its clients and its memory
 * stick. It knows of no hardware: the dog adds variables with something behind them ({@link Variable.Hardware}) and functions
 * ({@link Functions}), and gives it the time. Written from the URBI sheet alone; everything is called with the lab's lock held.
 */
@NullMarked
package majicsim.aibo.urbi;

import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Functions;
import org.jspecify.annotations.NullMarked;
