package majic.hemisson.parameters;

import java.util.function.UnaryOperator;
import majic.hemisson.line.BlockingConversation;
import majic.hemisson.line.Leds;
import majic.hemisson.line.Question;

/**
 * Switches the LEDs and the buzzer. The robot never reports them, so their last confirmed state is kept here.
 * Thread-safe.
 */
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

    /** Changes the LEDs and blocks until the robot confirms, where the thread may block. */
    void light(UnaryOperator<Leds> change) {
        Leds wanted = change.apply(leds);
        answers.send(Question.leds(wanted));
        leds = wanted;
    }

    /** Switches the buzzer and blocks until the robot confirms, where the thread may block. */
    void buzz(boolean on) {
        answers.send(Question.buzzer(on));
        buzzing = on;
    }

    /** Sets all to off, after a reset of the robot. */
    public void forget() {
        leds = Leds.OFF;
        buzzing = false;
    }
}
