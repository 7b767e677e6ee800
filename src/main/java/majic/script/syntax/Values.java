package majic.script.syntax;

import java.util.List;

/**
 * What the names and readings in a script stand for while a piece of it is parsed: before a run only the kinds of
 * values are known, during a run the values. The methods throw a {@link ScriptException} at what cannot be had.
 */
public interface Values {
    /** Where there are no names and no robots. */
    Values NONE = new Values() {
        @Override
        public Operand named(Token name) {
            throw new ScriptException(name, name.text() + ": there is no value of that name");
        }

        @Override
        public void declare(Token name, Operand value) {
            throw new ScriptException(name, name.text() + ": no value can have a name here");
        }

        @Override
        public Operand reading(Robots robots, Token parameter) {
            throw new ScriptException(parameter, parameter.text() + ": no robot can be read here");
        }

        @Override
        public Operand between(Token function, List<Token> ends) {
            throw new ScriptException(function, function.text() + ": there is no robot here");
        }

        @Override
        public double random() {
            return 0;
        }
    };

    /** The value of {@code $name}; the token is without the sign. */
    Operand named(Token name);

    /** Takes notice, before a run, of what a line will give a name; does nothing during a run. */
    void declare(Token name, Operand value);

    /** A parameter of one robot. */
    Operand reading(Robots robots, Token parameter);

    /**
     * The distance between two robots or places, mm, or the bearing from the first one to the second, degrees.
     *
     * @param function {@code distance} or {@code bearing}
     * @param ends two of them: numbers and names of robots, names of places
     */
    Operand between(Token function, List<Token> ends);

    /** A random number from 0 to less than 1. */
    double random();
}
