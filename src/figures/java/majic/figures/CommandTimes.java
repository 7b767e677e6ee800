package majic.figures;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import majic.team.Member;
import majic.team.QueuedCommand;

/**
 * Commands at a steady rate to the robots of a team, one robot after the other, and the times until they were sent. A
 * time begins before the command is submitted to the robot's queue and ends when the robot's driver has passed all its
 * bytes to the system. Both ends read the clock only, so measuring costs less than a tenth of a microsecond.
 */
final class CommandTimes {
    /** Turns on the spot, slowly to and fro, so that a robot between walls need not stop, degrees per second. */
    private static final double TURN_DEG_PER_SEC = 10;

    private final List<Member> robots;
    private final long[] nanos;
    private final AtomicInteger sent = new AtomicInteger();
    private double seconds;

    /** Prepares a number of commands. */
    CommandTimes(List<Member> robots, int commands) {
        this.robots = robots;
        this.nanos = new long[commands];
    }

    /** Sends all commands, and waits until each has ended. */
    void run(int perSecond) throws InterruptedException {
        long began = System.nanoTime();
        long stepNanos = TimeUnit.SECONDS.toNanos(1) / perSecond;
        for (int number = 0; number < nanos.length; number++) {
            long due = began + number * stepNanos;
            for (long left = due - System.nanoTime(); left > 0; left = due - System.nanoTime()) {
                LockSupport.parkNanos(left);
            }
            submit(robots.get(number % robots.size()), number / robots.size());
        }
        while (!robots.stream().allMatch(Member::isIdle)) {
            Thread.sleep(1);
        }
        seconds = (System.nanoTime() - began) / 1e9;
    }

    private void submit(Member robot, int round) {
        double rate = round % 2 == 0 ? TURN_DEG_PER_SEC : -TURN_DEG_PER_SEC;
        long began = System.nanoTime();
        robot.submit(
                new QueuedCommand("drive", true, control -> {
                    control.drive(0, rate);
                    nanos[sent.getAndIncrement()] = System.nanoTime() - began;
                    return List.of();
                }),
                null);
    }

    /** Returns how many commands failed or were not run. */
    int notSent() {
        return nanos.length - sent.get();
    }

    double perSecond() {
        return sent.get() / seconds;
    }

    /** Returns the time within which a share of the commands was sent, ms. */
    double withinMs(double share) {
        long[] sorted = Arrays.copyOf(nanos, sent.get());
        Arrays.sort(sorted);
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.min(sorted.length - 1, sorted.length * share)] / 1e6;
    }
}
