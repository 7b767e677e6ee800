package majic.gui.start;

import java.util.List;
import java.util.function.Predicate;

/**
 * A step of the tour: what to do, and how it shows that it was done. Immutable.
 *
 * @param title a few words
 * @param text what to do; {@code N} stands for the number of the lab's Pioneer
 * @param done whether it was done since the step began
 */
record TourStep(String title, String text, Predicate<TourEvents> done) {
    /** All steps in their order. */
    static final List<TourStep> ALL = List.of(
            new TourStep(
                    "The simulated lab",
                    "Choose Lab > Start the simulated lab. An Aibo, a Pioneer and a Hemisson appear in a room that exists"
                            + " only on this computer. The map shows where they are.",
                    events -> events.pioneer().isPresent()),
            new TourStep(
                    "A command",
                    "Click the command line at the bottom, type\n\n    N move 500\n\nand press Enter. The Pioneer drives"
                            + " half a metre ahead; its answer appears among the messages.",
                    events -> events.answered("N move .*: done.*")),
            new TourStep(
                    "A reading",
                    "Type\n\n    N get distanceFront\n\nThe answer is the free way ahead, in mm. The key Tab completes"
                            + " commands and parameters; Help lists them all.",
                    events -> events.answered("N distanceFront = .*")),
            new TourStep(
                    "Driving by hand",
                    "Select robot N, click the pad with the arrows below its panel, and hold the arrow key Up. The robot"
                            + " drives as long as the key is held.",
                    TourEvents::wasDrivenByHand),
            new TourStep(
                    "STOP",
                    "Press F12, or click the red button. Every robot stops, and none moves until you allow it. This works in"
                            + " every window of MAJIC, at any time.",
                    TourEvents::isLatched),
            new TourStep(
                    "Release",
                    "Click Release beside the red button. Motion is allowed again; nothing resumes by itself.",
                    events -> !events.isLatched()),
            new TourStep(
                    "An act",
                    "An act is a program that controls a robot. Click Load Act, choose robot N, then PioneerWander: the"
                            + " robot explores the room.",
                    TourEvents::hasAct),
            new TourStep(
                    "The end of an act",
                    "Select robot N and choose Act > End Act, or press Ctrl E. The robot stops and obeys you again.",
                    events -> !events.hasAct()),
            new TourStep(
                    "A saved session",
                    "Click Save Session and choose a file. It is a script of what you did, which the robots can do again:"
                            + " File > Open, or the command run.",
                    events -> events.answered("save session .*: done")));
}
