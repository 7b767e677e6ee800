package majic.gui.start;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import majic.log.Line;
import majic.log.SessionListener;
import majic.script.Session;
import majic.team.ManualCommand;
import majic.team.Member;
import majic.team.Owner;
import majic.team.TeamListener;

/** What has happened in the session since a step of the tour began. Thread-safe. */
final class TourEvents implements SessionListener, TeamListener, AutoCloseable {
    private static final String ROBOT = "pioneer";
    private static final int MOST_ANSWERS = 500;

    /** The Pioneer's number where the lab's robots are the first of the team. */
    private static final int USUAL_NUMBER = 2;

    private final Session session;
    private final List<String> answers = new CopyOnWriteArrayList<>();
    private volatile boolean drivenByHand;

    TourEvents(Session session) {
        this.session = session;
        session.addListener(this);
        session.team().addListener(this);
    }

    /** Begins another step. */
    void begin() {
        answers.clear();
        drivenByHand = false;
    }

    /** Returns the number of the lab's Pioneer, with which the tour is made; empty while it is not connected. */
    OptionalInt pioneer() {
        return robot().stream().mapToInt(Member::number).findFirst();
    }

    private Optional<Member> robot() {
        return session.team().members().stream()
                .filter(member -> session.factory().nameInLab(member.bot()).equals(Optional.of(ROBOT)))
                .filter(member -> member.bot().isConnected())
                .findFirst();
    }

    /** Returns the number that the robot has or probably gets. */
    int robotNumber() {
        return pioneer().orElse(USUAL_NUMBER);
    }

    /** Returns whether an answer matched a pattern, in which {@code N} stands for the number of the robot. */
    boolean answered(String pattern) {
        Pattern wanted = Pattern.compile(pattern.replaceAll("\\bN\\b", "" + robotNumber()));
        return answers.stream().anyMatch(answer -> wanted.matcher(answer).matches());
    }

    boolean wasDrivenByHand() {
        return drivenByHand;
    }

    boolean isLatched() {
        return session.team().isLatched();
    }

    /** Returns whether an act has the robot. */
    boolean hasAct() {
        return robot().map(Member::owner)
                .filter(owner -> owner.kind() == Owner.Kind.ACT)
                .isPresent();
    }

    @Override
    public void line(Line line) {
        if (line.kind() == Line.Kind.ANSWER && answers.size() < MOST_ANSWERS) {
            answers.add(line.text());
        }
    }

    @Override
    public void drivenManually(Member member, List<ManualCommand> commands) {
        drivenByHand = true;
    }

    @Override
    public void close() {
        session.removeListener(this);
        session.team().removeListener(this);
    }
}
