package majic.bot;

import org.jspecify.annotations.Nullable;

/**
 * A person's hand on one robot. {@link #drive} is called again and again while a key is held, from the event thread: it
 * never blocks, and each call leads to at most one command. When the calls end, for whatever reason, the robot stands
 * 600 ms later. Thread-safe.
 */
public final class Hand implements AutoCloseable {
    private final Member member;
    private final Owner owner;
    private final Permit lease = new Permit();
    private final Signal wanted;
    private @Nullable Wish wish;
    private volatile boolean released;

    private record Wish(double mmPerSec, double degPerSec) {}

    /**
     * Takes a robot into the hand.
     *
     * @param member which robot
     * @throws BotException if a script or act has it, it has orders in its queue, or STOP is latched
     */
    public Hand(Member member) {
        this.member = member;
        this.owner = new Owner(Owner.Kind.HAND, "the hand", this::release);
        this.wanted = member.bot().time().signal();
        member.check(true, null);
        if (!member.isIdle()) {
            throw new BotException(member.number() + " is busy; \"" + member.number() + " stop\" ends it");
        }
        member.claim(owner);
        member.bot()
                .time()
                .thread("robot " + member.number() + " by hand", this::run)
                .start();
    }

    /**
     * Drives on, for the next 600 ms.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     */
    public void drive(double mmPerSec, double degPerSec) {
        synchronized (this) {
            wish = new Wish(mmPerSec, degPerSec);
        }
        wanted.raise();
    }

    /** Stands, and lets the robot go. Returns at once. */
    @Override
    public void close() {
        release();
    }

    private void release() {
        released = true;
        lease.revoke(() -> new MotionStopped("the hand is off"));
        wanted.raise();
    }

    /** Ends in a stand however it ends; the lease is gone before, so that nothing more is driven after a stop. */
    private void run() {
        BotControl robot = member.control(lease);
        try {
            while (!released) {
                wanted.await(() -> released || hasWish(), Signal.FOR_EVER);
                Wish next = take();
                if (next != null && !released) {
                    robot.drive(next.mmPerSec, next.degPerSec);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (BotException e) {
            if (!(e instanceof MotionStopped)) {
                member.complain(e);
            }
        } finally {
            release();
            stand(robot);
            member.free(owner);
        }
    }

    private void stand(BotControl robot) {
        try {
            robot.drive(0, 0);
        } catch (BotException e) {
            Team.LOG.log(System.Logger.Level.DEBUG, "a hand could not let robot " + member.number() + " stand", e);
        }
    }

    private synchronized boolean hasWish() {
        return wish != null;
    }

    private synchronized @Nullable Wish take() {
        Wish taken = wish;
        wish = null;
        return taken;
    }
}
