package majicsim.aibo;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** Sends a transcript to a dog in an exact lab at the pace of the record and keeps what comes back. */
final class Replay {
    /** How long the recording program waited after each line. */
    private static final double PACE_MS = 228;

    private static final double LONGEST_WAIT_MS = 20_000;

    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();
    private final List<String> expected = new ArrayList<>();
    private final List<String> received = new ArrayList<>();

    /** @param leftOut what is not sent; the line end behind it is, for the kernel counts lines */
    static Replay of(Transcript transcript, Predicate<String> leftOut) {
        Replay replay = new Replay();
        for (Transcript.Exchange exchange : transcript.exchanges()) {
            replay.exchange(leftOut.test(exchange.sent()) ? exchange.leftOut() : exchange);
        }
        replay.waitForAll();
        return replay;
    }

    List<String> expected() {
        return expected;
    }

    List<String> received() {
        return received;
    }

    /** The order of a listing is that of a hash table, so both are sorted. */
    private void exchange(Transcript.Exchange exchange) {
        int before = received.size();
        List<String> answer = exchange.received();
        boolean listing = exchange.sent().equals("def;");
        expected.addAll(listing ? answer.stream().sorted().toList() : answer);
        client.say(exchange.sent() + "\n");
        bench.run(PACE_MS);
        take();
        waitForAll();
        if (listing) {
            received.subList(before, received.size()).sort(null);
        }
    }

    private void waitForAll() {
        for (double waited = 0; waited < LONGEST_WAIT_MS && received.size() < expected.size(); waited += 32) {
            bench.run(32);
            take();
        }
    }

    private void take() {
        client.take().stream().map(Transcript::plain).forEach(received::add);
    }
}
