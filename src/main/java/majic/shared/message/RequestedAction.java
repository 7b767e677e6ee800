package majic.shared.message;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.bot.Value;

/** What a request asks a robot to do. Immutable; {@code toString()} is how answers repeat it. */
public sealed interface RequestedAction {
    /**
     * Moves the robot if its {@code until} does not hold already; the text of a condition in MAJIC Script, or empty.
     */
    sealed interface Motion extends RequestedAction {
        /**
         * Returns the condition that ends the motion early.
         *
         * @return MAJIC Script; empty for none
         */
        String until();
    }

    /** A motion that a robot makes alone, without a map. */
    sealed interface Maneuver extends Motion {
        /**
         * Checks the arguments; nothing is sent.
         *
         * @param bot the robot that is to move
         * @throws majic.bot.BotException if the robot cannot do this
         */
        void check(MajicBot bot);

        /**
         * Moves the robot; returns when the motion has ended.
         *
         * @param control the permission to move the robot
         * @param guard ends the motion early; made from {@link #until()}
         * @return what the robot did
         * @throws majic.bot.BotException if the motion was stopped or failed
         */
        MotionReport perform(BotControl control, Guard guard);
    }

    /**
     * Drives straight.
     *
     * @param mm ahead positive
     * @param until MAJIC Script; empty for none
     */
    record Move(double mm, String until) implements Maneuver {
        @Override
        public String toString() {
            return "move " + Value.plain(mm) + behind(until);
        }

        @Override
        public void check(MajicBot bot) {
            bot.checkMove(mm);
        }

        @Override
        public MotionReport perform(BotControl control, Guard guard) {
            return control.move(mm, guard);
        }
    }

    /**
     * Turns on the spot.
     *
     * @param degrees counterclockwise positive
     * @param until MAJIC Script; empty for none
     */
    record Turn(double degrees, String until) implements Maneuver {
        @Override
        public String toString() {
            return "turn " + Value.plain(degrees) + behind(until);
        }

        @Override
        public void check(MajicBot bot) {
            bot.checkTurn(degrees);
        }

        @Override
        public MotionReport perform(BotControl control, Guard guard) {
            return control.turn(degrees, guard);
        }
    }

    /**
     * Drives a curve for a time.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     * @param seconds for how long
     * @param until MAJIC Script; empty for none
     */
    record Drive(double mmPerSec, double degPerSec, double seconds, String until) implements Maneuver {
        @Override
        public String toString() {
            return "drive " + Value.plain(mmPerSec) + " " + Value.plain(degPerSec) + " for " + Value.plain(seconds)
                    + "s" + behind(until);
        }

        @Override
        public void check(MajicBot bot) {
            bot.checkDrive(mmPerSec, degPerSec, seconds);
        }

        @Override
        public MotionReport perform(BotControl control, Guard guard) {
            return control.drive(mmPerSec, degPerSec, seconds, guard);
        }
    }

    /**
     * Drives to a place, by the map and the navigation of the desk.
     *
     * @param pose in the frame of the desk; its heading counts only if {@code withHeading}
     * @param withHeading whether the robot turns to the heading there
     * @param until MAJIC Script; empty for none
     */
    record GoTo(Pose pose, boolean withHeading, String until) implements Motion {
        @Override
        public String toString() {
            return "goto " + Value.plain(pose.xMm()) + " " + Value.plain(pose.yMm())
                    + (withHeading ? " " + Value.plain(pose.headingDeg()) : "") + behind(until);
        }
    }

    /**
     * Reads a parameter, asking the robot where that is needed.
     *
     * @param parameter its name
     */
    record Get(String parameter) implements RequestedAction {
        @Override
        public String toString() {
            return "get " + parameter;
        }
    }

    /**
     * Sets a parameter.
     *
     * @param parameter its name
     * @param values its value, then any extras; numbers in the units of the description
     */
    record Set(String parameter, List<Value> values) implements RequestedAction {
        @Override
        public String toString() {
            return "set " + words(parameter, values);
        }
    }

    /**
     * Runs a command that only this type of robot has.
     *
     * @param command its name
     * @param arguments numbers in the units of the description
     */
    record Run(String command, List<Value> arguments) implements RequestedAction {
        @Override
        public String toString() {
            return words(command, arguments);
        }
    }

    /** Claims the robot until it is given back. */
    record Hold() implements RequestedAction {
        @Override
        public String toString() {
            return "hold";
        }
    }

    /** Gives the robot back. */
    record Free() implements RequestedAction {
        @Override
        public String toString() {
            return "free";
        }
    }

    /** Sends a picture of the camera. */
    record Picture() implements RequestedAction {
        @Override
        public String toString() {
            return "picture";
        }
    }

    /** Sends what the range sensors measure for some seconds. */
    record Scans() implements RequestedAction {
        @Override
        public String toString() {
            return "scans";
        }
    }

    /** Looks for the robot everywhere on the map of its desk. */
    record Localize() implements RequestedAction {
        @Override
        public String toString() {
            return "localize";
        }
    }

    private static String behind(String until) {
        return until.isEmpty() ? "" : " until " + until;
    }

    private static String words(String name, List<Value> values) {
        return Stream.concat(Stream.of(name), values.stream().map(Value::toString))
                .collect(Collectors.joining(" "));
    }

    /** Adds the fields of an action. */
    static void write(RequestedAction action, ObjectNode to) {
        if (action instanceof Move move) {
            to.put("do", "move").put("mm", move.mm());
        } else if (action instanceof Turn turn) {
            to.put("do", "turn").put("degrees", turn.degrees());
        } else if (action instanceof Drive drive) {
            to.put("do", "drive").put("mmPerSec", drive.mmPerSec()).put("degPerSec", drive.degPerSec());
            to.put("seconds", drive.seconds());
        } else if (action instanceof GoTo place) {
            to.put("do", "goto")
                    .put("x", place.pose().xMm())
                    .put("y", place.pose().yMm());
            if (place.withHeading()) {
                to.put("heading", place.pose().headingDeg());
            }
        } else if (action instanceof Get get) {
            to.put("do", "get").put("parameter", get.parameter());
        } else if (action instanceof Set set) {
            write(to.put("do", "set").put("parameter", set.parameter()).putArray("values"), set.values());
        } else if (action instanceof Run run) {
            write(to.put("do", "run").put("command", run.command()).putArray("arguments"), run.arguments());
        } else {
            to.put("do", action.toString());
        }
        if (action instanceof Motion motion && !motion.until().isEmpty()) {
            to.put("until", motion.until());
        }
    }

    private static void write(ArrayNode to, List<Value> values) {
        values.forEach(value -> to.add(ValueJson.of(value)));
    }

    /** Reads the fields of an action. */
    static RequestedAction read(JsonObject from) {
        String until = from.text("until", "");
        return switch (from.text("do")) {
            case "move" -> new Move(from.number("mm"), until);
            case "turn" -> new Turn(from.number("degrees"), until);
            case "drive" ->
                new Drive(from.number("mmPerSec"), from.number("degPerSec", 0), from.number("seconds", 1), until);
            case "goto" ->
                new GoTo(
                        new Pose(from.number("x"), from.number("y"), from.number("heading", 0)),
                        from.has("heading"),
                        until);
            case "get" -> new Get(from.text("parameter"));
            case "set" -> new Set(from.text("parameter"), from.list("values", ValueJson::given));
            case "run" -> new Run(from.text("command"), from.list("arguments", ValueJson::given));
            case "hold" -> new Hold();
            case "free" -> new Free();
            case "picture" -> new Picture();
            case "scans" -> new Scans();
            case "localize" -> new Localize();
            default ->
                throw from.wrong(
                        "do",
                        "it is one of move, turn, drive, goto, get, set, run, hold, free, picture, scans, localize");
        };
    }
}
