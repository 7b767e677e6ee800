package majic.gui.plot.data;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.DoubleSupplier;
import majic.team.Answer;
import majic.team.CommandListener;
import majic.team.Member;
import majic.team.Owner;
import majic.team.TeamListener;
import majic.text.Texts;

/** Records when commands, acts and scripts on robots begin and end, the newest {@value #MOST} moments. Thread-safe. */
final class MarkRecord implements TeamListener, CommandListener {
    private static final Texts TEXTS = Texts.of(MarkRecord.class);
    private static final int MOST = 2000;

    private final DoubleSupplier now;
    private final Deque<PlotMark> marks = new ArrayDeque<>();

    /**
     * Creates an empty record.
     *
     * @param now gives the time, seconds
     */
    MarkRecord(DoubleSupplier now) {
        this.now = now;
    }

    @Override
    public void begun(int robot, String command) {
        add(robot, robot + " " + command, false);
    }

    @Override
    public void answered(Answer answer) {
        if (answer.robot() > 0) {
            add(answer.robot(), answer.text(), true);
        }
    }

    @Override
    public void ownerChanged(Member member) {
        Owner owner = member.owner();
        if (owner != null) {
            add(member.number(), member.number() + " " + owner.name(), false);
        }
    }

    @Override
    public void latchChanged(boolean latched) {
        add(0, latched ? stopText() : TEXTS.get("released"), latched);
    }

    /** Returns the text of the mark of STOP. */
    static String stopText() {
        return TEXTS.get("stop");
    }

    /** Replaces the marks up to a time by those that were recorded. */
    synchronized void replace(List<PlotMark> recorded, double until) {
        List<PlotMark> later =
                marks.stream().filter(mark -> mark.seconds() > until).toList();
        marks.clear();
        recorded.subList(Math.max(0, recorded.size() - MOST / 2), recorded.size())
                .forEach(marks::add);
        marks.addAll(later);
    }

    private synchronized void add(int robot, String text, boolean end) {
        if (marks.size() == MOST) {
            marks.removeFirst();
        }
        marks.addLast(new PlotMark(now.getAsDouble(), robot, text, end));
    }

    /** Returns the marks within a span of time, oldest first. */
    synchronized List<PlotMark> between(double from, double to) {
        return marks.stream()
                .filter(mark -> mark.seconds() >= from && mark.seconds() <= to)
                .toList();
    }
}
