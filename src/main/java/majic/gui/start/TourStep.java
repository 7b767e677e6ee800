package majic.gui.start;

import java.util.List;
import java.util.function.Predicate;

/**
 * A step of the tour: what to do, and how it shows that it was done. Immutable.
 *
 * @param title key of its title
 * @param text key of the text that says what to do; takes the number of the lab's Pioneer
 * @param done whether it was done since the step began
 */
record TourStep(String title, String text, Predicate<TourEvents> done) {
    /** All steps in their order. */
    static final List<TourStep> ALL = List.of(
            new TourStep("step.lab", "step.lab.text", events -> events.pioneer().isPresent()),
            new TourStep("step.command", "step.command.text", events -> events.answered("N move .*: done.*")),
            new TourStep("step.reading", "step.reading.text", events -> events.answered("N distanceFront = .*")),
            new TourStep("step.byHand", "step.byHand.text", TourEvents::wasDrivenByHand),
            new TourStep("step.stop", "step.stop.text", TourEvents::isLatched),
            new TourStep("step.release", "step.release.text", events -> !events.isLatched()),
            new TourStep("step.act", "step.act.text", TourEvents::hasAct),
            new TourStep("step.endAct", "step.endAct.text", events -> !events.hasAct()),
            new TourStep("step.session", "step.session.text", events -> events.answered("save session .*: done")));
}
