package majic.gui.command;

import java.util.EnumSet;
import java.util.Set;
import majic.log.Line;
import majic.text.Texts;

/**
 * Selects the messages that are shown. An alarm is always shown. Immutable.
 *
 * @param robot hides messages that begin with the numbers of other robots; {@value #ALL_ROBOTS} hides none
 * @param shown the groups of kinds to show
 */
record MessageFilter(int robot, Set<Group> shown) {
    private static final Texts TEXTS = Texts.of(MessageFilter.class);
    static final int ALL_ROBOTS = 0;
    static final MessageFilter EVERYTHING = new MessageFilter(ALL_ROBOTS, EnumSet.allOf(Group.class));

    /** Kinds of messages that are shown or hidden together. */
    enum Group {
        COMMANDS("commands"),
        ANSWERS("answers"),
        NOTICES("notices"),
        PROBLEMS("problems");

        private final String key;

        Group(String key) {
            this.key = key;
        }

        String label() {
            return TEXTS.get(key);
        }

        private static Group of(Line.Kind kind) {
            return switch (kind) {
                case COMMAND -> COMMANDS;
                case ANSWER -> ANSWERS;
                case NOTICE -> NOTICES;
                case FAILURE, ERROR, ALARM -> PROBLEMS;
            };
        }
    }

    /** Keeps a copy of the set. */
    MessageFilter {
        shown = Set.copyOf(shown);
    }

    /** Returns what a filter for a robot, or for all of them, is called. */
    static String label(int robot) {
        return robot == ALL_ROBOTS ? TEXTS.get("robot.all") : TEXTS.get("robot.only", robot);
    }

    boolean accepts(Message message) {
        Set<Integer> robots = message.robots();
        boolean ofRobot = robot == ALL_ROBOTS || robots.isEmpty() || robots.contains(robot);
        return message.line().kind() == Line.Kind.ALARM
                || (ofRobot && shown.contains(Group.of(message.line().kind())));
    }

    MessageFilter forRobot(int number) {
        return new MessageFilter(number, shown);
    }

    MessageFilter with(Group group, boolean isShown) {
        EnumSet<Group> groups = EnumSet.noneOf(Group.class);
        groups.addAll(shown);
        if (isShown) {
            groups.add(group);
        } else {
            groups.remove(group);
        }
        return new MessageFilter(robot, groups);
    }
}
