package majic.gui.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.swing.text.Segment;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.SessionParser;
import majic.script.syntax.Scanner;
import majic.script.syntax.Token;
import org.fife.ui.rsyntaxtextarea.TokenMakerBase;
import org.fife.ui.rsyntaxtextarea.TokenTypes;

/** Splits lines of MAJIC Script into the pieces that the editor colours, by the scanner of the language. */
final class ScriptTokens extends TokenMakerBase {
    /** The words that join the parts of a command or a condition. */
    private static final Set<String> JOINING =
            Set.of("and", "any", "as", "every", "for", "not", "now", "off", "or", "until", "with");

    /** The words that robots may follow. */
    private static final Set<String> BEFORE_ROBOTS =
            Set.of("and", "if", "not", "or", "remove", "until", "while", "with");

    private static final Set<String> ROBOT_WORDS = Set.of("all", "any", "me");

    /** What is coloured alike, with the types of the library. */
    static final int COMMAND = TokenTypes.RESERVED_WORD;

    static final int JOINT = TokenTypes.RESERVED_WORD_2;
    static final int OWN_COMMAND = TokenTypes.FUNCTION;
    static final int ROBOT = TokenTypes.DATA_TYPE;
    static final int NAME = TokenTypes.VARIABLE;
    static final int NUMBER = TokenTypes.LITERAL_NUMBER_FLOAT;
    static final int TEXT = TokenTypes.LITERAL_STRING_DOUBLE_QUOTE;
    static final int OPEN_TEXT = TokenTypes.ERROR_STRING_DOUBLE;
    static final int COMMENT = TokenTypes.COMMENT_EOL;
    static final int SIGN = TokenTypes.OPERATOR;
    static final int PLAIN = TokenTypes.IDENTIFIER;

    @Override
    public org.fife.ui.rsyntaxtextarea.Token getTokenList(Segment text, int initialTokenType, int startOffset) {
        resetTokenList();
        int at = 0;
        for (Piece piece : pieces(text.toString())) {
            if (piece.start() > at) {
                add(text, at, piece.start(), TokenTypes.WHITESPACE, startOffset);
            }
            add(text, piece.start(), piece.end(), piece.type(), startOffset);
            at = piece.end();
        }
        if (at < text.count) {
            add(text, at, text.count, TokenTypes.WHITESPACE, startOffset);
        }
        addNullToken();
        return firstToken;
    }

    private void add(Segment text, int start, int end, int type, int startOffset) {
        addToken(text, text.offset + start, text.offset + end - 1, type, startOffset + start);
    }

    @Override
    public String[] getLineCommentStartAndEnd(int languageIndex) {
        return new String[] {"# ", null};
    }

    @Override
    public boolean getMarkOccurrencesOfTokenType(int type) {
        return false;
    }

    /**
     * A part of a line that has one colour.
     *
     * @param start its first character, from 0
     * @param end behind its last character
     */
    record Piece(int start, int end, int type) {}

    /** The pieces of a line, without the blanks between them. */
    static List<Piece> pieces(String line) {
        List<Token> tokens = Scanner.scan(line);
        List<Piece> pieces = new ArrayList<>();
        Place place = new Place();
        for (Token token : tokens) {
            if (!token.isEnd()) {
                pieces.add(new Piece(token.column() - 1, token.end() - 1, place.type(token)));
            } else if (token.kind() == Token.Kind.NEWLINE && token.column() <= line.length()) {
                pieces.add(new Piece(token.column() - 1, line.length(), COMMENT));
            }
        }
        return pieces;
    }

    /** Where in a line the next token stands: among robots, behind them, or behind the command. */
    private static final class Place {
        private boolean isFirst = true;
        private boolean namesRobots;
        private boolean followsRobot;
        private boolean awaitsCommand;

        int type(Token token) {
            int type = typeHere(token);
            isFirst = false;
            return type;
        }

        private int typeHere(Token token) {
            return switch (token.kind()) {
                case NUMBER, SPAN -> isFirst || namesRobots ? robot() : NUMBER;
                case WORD -> word(token);
                case QUOTED -> TEXT;
                case VARIABLE -> NAME;
                case OPEN_QUOTE -> OPEN_TEXT;
                case COMMA -> comma();
                case OPERATOR, DOT, LEFT, RIGHT, OTHER -> SIGN;
                case NEWLINE, END -> PLAIN;
            };
        }

        private int comma() {
            namesRobots |= followsRobot;
            followsRobot = false;
            return SIGN;
        }

        private int robot() {
            awaitsCommand |= isFirst;
            namesRobots = false;
            followsRobot = true;
            return ROBOT;
        }

        private int word(Token token) {
            boolean begins = token.isOneOf(SessionParser.WORDS) || token.isOneOf(ScriptParser.BLOCK_WORDS);
            if (isFirst && begins) {
                namesRobots = token.isOneOf(BEFORE_ROBOTS);
                return COMMAND;
            }
            if (isFirst || token.isOneOf(ROBOT_WORDS) || (namesRobots && awaitsCommand)) {
                return robot();
            }
            followsRobot = false;
            if (awaitsCommand) {
                awaitsCommand = false;
                return token.isOneOf(LineParser.COMMAND_WORDS) ? COMMAND : OWN_COMMAND;
            }
            namesRobots = token.isOneOf(BEFORE_ROBOTS);
            return token.isOneOf(JOINING) ? JOINT : NAME;
        }
    }
}
