package majic.aibo.panel;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.driver.RobotWait;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Asks for pictures, one at a time: none is asked for while an earlier one may still be on its way. Thread-safe. */
final class Camera {
    private static final Texts TEXTS = Texts.of(Camera.class);
    static final double LONGEST_S = 4;

    private final RobotWait waiting;
    private final Tags tags = new Tags();
    private final AtomicReference<@Nullable Request> pending = new AtomicReference<>();

    private record Request(UrbiConnection on, UrbiRequest ask) {}

    Camera(RobotWait waiting) {
        this.waiting = waiting;
    }

    /**
     * Asks for a picture, unless one is on its way, and waits for it.
     *
     * @param over ends the waiting; the picture on its way is then the next caller's
     * @return what the dog answered; null if the waiting was ended
     * @throws UrbiRefusal if none comes in time, or the dog reports why there is none
     * @throws majic.bot.LinkLost if the connection is gone
     */
    @Nullable
    UrbiValue next(UrbiConnection on, BooleanSupplier over) {
        Request request = request(on);
        UrbiRequest ask = request.ask();
        waiting.await(() -> ask.isDone() || on.isEnded() || over.getAsBoolean(), LONGEST_S);
        if (!ask.isDone() && over.getAsBoolean()) {
            return null;
        }
        on.forget(ask);
        pending.compareAndSet(request, null);
        UrbiValue picture = ask.value();
        if (picture == null) {
            throw new UrbiRefusal(why(ask));
        }
        return picture;
    }

    private static String why(UrbiRequest ask) {
        String failure = ask.failure();
        return failure == null ? TEXTS.get("camera.late", (int) LONGEST_S) : TEXTS.get("camera.failed", failure);
    }

    /** The one under way, or a new one; a picture that came while no thread waited for it is an old one. */
    private Request request(UrbiConnection on) {
        Request last = pending.get();
        if (last != null && last.on() == on && !last.ask().isDone()) {
            return last;
        }
        Request fresh = new Request(on, new UrbiRequest(tags.next(), UrbiRequest.Expects.VALUE));
        if (!pending.compareAndSet(last, fresh)) {
            return request(on);
        }
        on.send(fresh.ask(), on.version().labelled(fresh.ask().tag(), "camera.val") + ";");
        return fresh;
    }
}
