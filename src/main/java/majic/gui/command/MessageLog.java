package majic.gui.command;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import majic.log.Line;

/**
 * The newest messages, in which repeated ones are one: an error that repeats the one in front of it, and what further
 * presses of STOP give until the next command or release. While STOP is latched, its report counts the presses, all
 * confirmations of robots are one message, and a robot that has not confirmed is named again only if its answer differs
 * from its last one. Must be used on one thread.
 */
final class MessageLog {
    static final int MOST_KEPT = 2 * MessageDocument.MOST_LINES;
    private static final int NONE = -1;

    private final List<Message> kept = new ArrayList<>();
    private int removed;

    /** The places of the reports of a STOP by their texts, counted from the first message ever. */
    private final Map<String, Integer> reports = new HashMap<>();

    /** The place of the last answer of each stopped robot. */
    private final Map<Integer, Integer> answers = new HashMap<>();

    private boolean latched;
    private int confirmations = NONE;

    /** Returns the messages, oldest first; unmodifiable. */
    List<Message> all() {
        return List.copyOf(kept);
    }

    void clear() {
        removed += kept.size();
        kept.clear();
        endStop();
    }

    private void endStop() {
        reports.clear();
        answers.clear();
        latched = false;
        confirmations = NONE;
    }

    /**
     * Adds messages, and removes the oldest ones.
     *
     * @param replaced receives an earlier message and the one that is in its place from now on
     * @return those of the added messages that are not part of an earlier one
     */
    List<Message> add(List<Message> arrived, BiConsumer<Message, Message> replaced) {
        int before = kept.size();
        for (Message message : arrived) {
            int index = placeOf(message) - removed;
            if (index < 0 || index == kept.size()) {
                kept.add(message);
                continue;
            }
            Message old = kept.get(index);
            kept.set(index, joined(old, message));
            if (index < before && !kept.get(index).equals(old)) {
                replaced.accept(old, kept.get(index));
            }
        }
        List<Message> added = List.copyOf(kept.subList(before, kept.size()));
        int tooMany = Math.max(0, kept.size() - MOST_KEPT);
        kept.subList(0, tooMany).clear();
        removed += tooMany;
        return added;
    }

    /** Returns the place of the message of which another one becomes a part; {@value #NONE} if there is none. */
    private int placeOf(Message message) {
        int end = removed + kept.size();
        return switch (message.part()) {
            case END -> {
                endStop();
                yield NONE;
            }
            case LATCH, OVERDUE -> {
                latched |= message.part() == Message.Part.LATCH;
                yield reports.merge(message.line().text(), end, (earlier, now) -> earlier >= removed ? earlier : now);
            }
            case CONFIRMATION, FAILURE -> placeOfAnswer(message, end);
            case NONE -> repeatsLast(message) ? end - 1 : NONE;
        };
    }

    private int placeOfAnswer(Message message, int end) {
        int robot = message.robots().iterator().next();
        int last = answers.getOrDefault(robot, NONE);
        if (last >= removed && kept.get(last - removed).hasAnswerOf(message)) {
            return last;
        }
        if (message.part() == Message.Part.CONFIRMATION && latched) {
            boolean joins = confirmations >= removed && confirmations > last;
            confirmations = joins ? confirmations : end;
            answers.put(robot, confirmations);
            return joins ? confirmations : NONE;
        }
        answers.put(robot, end);
        return NONE;
    }

    private boolean repeatsLast(Message message) {
        return message.line().kind() == Line.Kind.ERROR
                && !kept.isEmpty()
                && kept.get(kept.size() - 1).line().text().equals(message.line().text());
    }

    private Message joined(Message old, Message added) {
        if (!latched || added.part() == Message.Part.LATCH || added.part() == Message.Part.NONE) {
            return old.and(added);
        }
        Set<Integer> robots = new TreeSet<>(old.robots());
        return robots.addAll(added.robots()) ? old.ofRobots(robots) : old;
    }
}
