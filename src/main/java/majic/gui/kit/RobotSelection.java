package majic.gui.kit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.team.Member;

/**
 * The robots that the user has selected: those shown large, driven by the pad, and meant by a command without robots.
 * Must be changed on the event dispatch thread; can be read on any thread.
 */
public final class RobotSelection {
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private volatile List<Member> members = List.of();

    /**
     * Adds a listener.
     *
     * @param changed runs on the event dispatch thread after each change
     */
    public void addListener(Runnable changed) {
        listeners.add(changed);
    }

    /** Returns the selected robots by number; unmodifiable. */
    public List<Member> members() {
        return members;
    }

    /** Returns the numbers of the selected robots, in increasing order. */
    public List<Integer> numbers() {
        return members.stream().map(Member::number).toList();
    }

    /** Returns the numbers of the selected robots as a command has them, such as {@code 1,3}. */
    public String numbersInLine() {
        return members.stream().map(member -> String.valueOf(member.number())).collect(Collectors.joining(","));
    }

    /** Returns the selected robot with the lowest number. */
    public Optional<Member> first() {
        return members.stream().findFirst();
    }

    public boolean contains(Member member) {
        return members.contains(member);
    }

    /** Selects one robot alone. */
    public void select(Member member) {
        set(List.of(member));
    }

    /** Selects these robots and no others. */
    public void set(List<Member> chosen) {
        List<Member> sorted =
                chosen.stream().sorted(Comparator.comparing(Member::number)).toList();
        if (!sorted.equals(members)) {
            members = sorted;
            listeners.forEach(Runnable::run);
        }
    }

    /** Adds a robot to the selection, or removes it if it is selected. */
    public void toggle(Member member) {
        if (contains(member)) {
            remove(member);
        } else {
            set(Stream.concat(members.stream(), Stream.of(member)).toList());
        }
    }

    /** Removes a robot from the selection; has no effect if it is not selected. */
    public void remove(Member member) {
        set(members.stream().filter(other -> other != member).toList());
    }
}
