package majic.hemisson.line;

/** A conversation with a robot played by the test, on a clock that it moves. */
final class TestedConversation {
    static final MotorValues AHEAD = new MotorValues(3, 3);

    /** The question with the longest answer that a moving robot is asked. */
    static final Question ULTRASONIC = Question.ask("R,E0,01,03", "r(,\\d{3}){3}", Question.msFor(13));

    final ManualClock clock = new ManualClock();
    final RecordingLink link = new RecordingLink();
    final RecordedEvents events = new RecordedEvents();
    final Conversation conversation;

    private TestedConversation(LineTimes times) {
        conversation = new Conversation(link, clock, times, events);
        conversation.setDeafenable(false);
    }

    static TestedConversation overCable() {
        return new TestedConversation(LineTimes.CABLE);
    }

    /** Over a line that holds bytes back; the robot's receiver is not known yet. */
    static TestedConversation overBufferedLine() {
        return new TestedConversation(LineTimes.BUFFERED);
    }

    /** Passes a line from the robot to the conversation. */
    void receive(String line) {
        conversation.bytesReceived();
        conversation.received(Reply.of(line));
    }

    void pass(double seconds) {
        clock.pass(seconds);
        conversation.tick();
    }
}
