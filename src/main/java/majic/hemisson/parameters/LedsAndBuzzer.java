package majic.hemisson.parameters;

import java.util.function.UnaryOperator;
import majic.hemisson.line.BlockingConversation;
import majic.hemisson.line.Leds;
import majic.hemisson.line.Question;

/** The lamps and the buzzer: switched together, and never told by the robot, so their state is kept here. Thread-safe. */
public final class LedsAndBuzzer {
    private final BlockingConversation answers;
    private volatile Leds leds = Leds.OFF;
    private volatile boolean buzzing;

    public LedsAndBuzzer(BlockingConversation answers) {
        this.answers = answers;
    }

    public Leds leds() {
        return leds;
    }

    public boolean isBuzzing() {
        return buzzing;
    }

    /** Changes the lamps and waits for the robot to confirm. */
    void light(UnaryOperator<Leds> change) {
        Leds wanted = change.apply(leds);
        answers.tell(Question.leds(wanted));
        leds = wanted;
    }

    /** Switches the buzzer and waits for the robot to confirm. */
    void buzz(boolean on) {
        answers.tell(Question.buzzer(on));
        buzzing = on;
    }

    /** After a reset all is off. */
    public void forget() {
        leds = Leds.OFF;
        buzzing = false;
    }
}
