package majic.script;

/**
 * Something wrong in a script. Immutable.
 *
 * @param line where, counted from 1
 * @param column where, counted from 1
 * @param message what is wrong and what would be right
 */
record Mistake(int line, int column, String message) {
    String in(String file) {
        return file + ":" + line + ":" + column + ": " + message;
    }
}
