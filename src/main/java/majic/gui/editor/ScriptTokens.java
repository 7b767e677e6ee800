package majic.gui.editor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
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
            Set.of("and", "any", "as", "every", "for", "from", "not", "now", "off", "or", "to", "until", "with");

    /** The words that robots may follow. */
    private static final Set<String> BEFORE_ROBOTS =
            Set.of("and", "if", "not", "on", "or", "remove", "until", "while", "with");

    /** The words that a name for a value follows. */
    private static final Set<String> BEFORE_NAME = Set.of("argument", "ask", "let");

    private static final Set<String> FUNCTIONS = Set.of("abs", "bearing", "distance", "max", "min", "random");

    private static final Set<String> ROBOT_WORDS = Set.of("all", "any", "me");

    /** What is coloured alike, with the types of the library. */
    static final int COMMAND = TokenTypes.RESERVED_WORD;

    static final int JOINT = TokenTypes.RESERVED_WORD_2;
    static final int OWN_COMMAND = TokenTypes.FUNCTION;
    static final int ROBOT = TokenTypes.DATA_TYPE;
    static final int NAME = TokenTypes.VARIABLE;
    static final int VALUE = TokenTypes.PREPROCESSOR;
    static final int NUMBER = TokenTypes.LITERAL_NUMBER_FLOAT;
    static final int TEXT = TokenTypes.LITERAL_STRING_DOUBLE_QUOTE;
    static final int OPEN_TEXT = TokenTypes.ERROR_STRING_DOUBLE;
    static final int COMMENT = TokenTypes.COMMENT_EOL;
    static final int SIGN = TokenTypes.OPERATOR;
    static final int PLAIN = TokenTypes.IDENTIFIER;

    private Set<String> procedures = Set.of();

    /** Sets the words that call procedures, in lower case. */
    void setProcedures(Set<String> words) {
        procedures = words;
    }

    @Override
    public org.fife.ui.rsyntaxtextarea.Token getTokenList(Segment text, int initialTokenType, int startOffset) {
        resetTokenList();
        int at = 0;
        for (Piece piece : pieces(text.toString(), procedures)) {
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

    /**
     * The pieces of a line, without the blanks between them.
     *
     * @param procedures the words that call procedures, in lower case
     */
    static List<Piece> pieces(String line, Set<String> procedures) {
        List<Token> tokens = Scanner.scan(line);
        List<Piece> pieces = new ArrayList<>();
        Place place = new Place(procedures);
        for (int index = 0; index < tokens.size(); index++) {
            Token token = tokens.get(index);
            if (!token.isEnd()) {
                pieces.add(new Piece(token.column() - 1, token.end() - 1, place.type(token, tokens.get(index + 1))));
            } else if (token.kind() == Token.Kind.NEWLINE && token.column() <= line.length()) {
                pieces.add(new Piece(token.column() - 1, line.length(), COMMENT));
            }
        }
        return pieces;
    }

    /** Where in a line the next token stands: among robots, behind them, or behind the command. */
    private static final class Place {
        private final Set<String> procedures;
        private final Deque<Boolean> brackets = new ArrayDeque<>();
        private boolean isFirst = true;
        private boolean awaitsName;
        private boolean namesProcedure;
        private boolean listsArguments;
        private boolean computes;
        private boolean isCall;
        private boolean namesRobots;
        private boolean followsRobot;
        private boolean awaitsCommand;

        Place(Set<String> procedures) {
            this.procedures = procedures;
        }

        int type(Token token, Token next) {
            int type = typeHere(token, next);
            isFirst = false;
            isCall |= token.kind() == Token.Kind.DOT;
            return type;
        }

        private int typeHere(Token token, Token next) {
            return switch (token.kind()) {
                case NUMBER, SPAN -> number(next);
                case WORD -> word(token, next);
                case QUOTED -> TEXT;
                case VARIABLE -> value();
                case OPEN_QUOTE -> OPEN_TEXT;
                case COMMA -> comma();
                case LEFT, RIGHT -> bracket(token.kind() == Token.Kind.LEFT);
                case OPERATOR, DOT, OTHER -> SIGN;
                case NEWLINE, END -> PLAIN;
            };
        }

        private int value() {
            namesRobots = false;
            return VALUE;
        }

        /** A bracket begins an expression or a part of a condition, but for that of a call. */
        private int bracket(boolean opens) {
            if (opens) {
                brackets.push(!isCall);
                isCall = false;
            } else {
                namesRobots = false;
                brackets.poll();
            }
            return SIGN;
        }

        private boolean inExpression() {
            return computes || Boolean.TRUE.equals(brackets.peek());
        }

        /** Whether a word that follows is the parameter of a robot, or a robot before it. */
        private boolean isBeforeParameter(Token next) {
            return inExpression()
                    && next.kind() == Token.Kind.WORD
                    && !next.isOneOf(JOINING)
                    && !next.isOneOf(FUNCTIONS)
                    && !next.is("to");
        }

        private int number(Token next) {
            return isFirst || namesRobots || isBeforeParameter(next) ? robot() : NUMBER;
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

        private int word(Token token, Token next) {
            if (isFirst && begins(token)) {
                namesRobots = token.isOneOf(BEFORE_ROBOTS);
                awaitsName = token.isOneOf(BEFORE_NAME);
                namesProcedure = token.is("to");
                computes = token.is("let");
                return COMMAND;
            }
            if (awaitsName || listsArguments) {
                awaitsName = false;
                return VALUE;
            }
            if (namesProcedure || isFirst && isProcedure(token, next)) {
                listsArguments = namesProcedure;
                return OWN_COMMAND;
            }
            return inExpression() ? operand(token, next) : plainWord(token);
        }

        private static boolean begins(Token token) {
            return token.isOneOf(SessionParser.WORDS)
                    || token.isOneOf(ScriptParser.BLOCK_WORDS)
                    || token.is("argument");
        }

        private boolean isProcedure(Token token, Token next) {
            return procedures.contains(token.text().toLowerCase(Locale.ROOT)) && next.kind() != Token.Kind.DOT;
        }

        private int operand(Token token, Token next) {
            if (token.isOneOf(FUNCTIONS) && !followsRobot) {
                return OWN_COMMAND;
            }
            boolean isRobot = !followsRobot && !token.isOneOf(JOINING) && isBeforeParameter(next);
            return isRobot ? robot() : plainWord(token);
        }

        private int plainWord(Token token) {
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
