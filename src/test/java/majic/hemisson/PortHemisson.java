package majic.hemisson;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import majic.drivertest.TestClock;
import majic.link.Links;
import majic.link.PseudoTerminal;
import majic.simulation.TransitCheck;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import majicsim.net.LineCount;

/**
 * A Hemisson at the other end of a serial port of the system; records what it received. Its clock is stepped: no time
 * passes while it or the driver has bytes to handle.
 */
final class PortHemisson implements AutoCloseable {
    private final PseudoTerminal plug = new PseudoTerminal();
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private final CountDownLatch moving = new CountDownLatch(1);
    private final CountDownLatch standing = new CountDownLatch(1);
    private final UnaryOperator<String> answers;
    private final AtomicLong consumed = new AtomicLong();
    private final AtomicLong written = new AtomicLong();
    private final TestClock clock =
            new TestClock(nanos -> {}, new TransitCheck(Links::traffic, this::lines, Set.of(plug.name())));
    private volatile boolean remembers = true;
    private volatile boolean isPulledWhenItMoves;
    private String speeds = "0,0";
    private volatile boolean pulled;

    private PortHemisson(UnaryOperator<String> answers) {
        this.answers = answers;
        Thread robot = new Thread(this::converse, "robot on a port");
        robot.setDaemon(true);
        robot.start();
    }

    static PortHemisson stock() {
        return new PortHemisson(PortHemisson::stock);
    }

    static PortHemisson roadNarrows() {
        return new PortHemisson(PortHemisson::roadNarrows);
    }

    String name() {
        return plug.name();
    }

    TimeSource time() {
        return clock.time();
    }

    private List<LineCount> lines() {
        return List.of(new LineCount(plug.name(), plug.name(), consumed.get(), written.get(), !pulled, false));
    }

    /** Pulls the plug at its next motion. */
    void pullWhenItMoves() {
        isPulledWhenItMoves = true;
    }

    List<String> heard() {
        return heard;
    }

    /** Records no commands any more; a benchmark sends too many. */
    void remembersNothing() {
        remembers = false;
    }

    void awaitMotion() {
        WaitLimit.await("the motion", moving);
    }

    /** Waits until it has received a stop after it moved. */
    void awaitStop() {
        WaitLimit.await("the stop", standing);
    }

    @Override
    public void close() {
        pull();
        clock.close();
    }

    private synchronized void pull() {
        if (!pulled) {
            pulled = true;
            plug.close();
        }
    }

    private void converse() {
        StringBuilder command = new StringBuilder();
        try {
            while (true) {
                String bytes = plug.read();
                for (char next : bytes.toCharArray()) {
                    if (next == '\r') {
                        take(command.toString());
                        command.setLength(0);
                    } else {
                        command.append(next);
                    }
                }
                consumed.addAndGet(bytes.length());
            }
        } catch (IOException | RuntimeException e) {
            moving.countDown();
            standing.countDown();
        }
    }

    private void take(String command) {
        if (remembers) {
            heard.add(command);
        }
        if (command.startsWith("D")) {
            speeds = command.substring(2);
        }
        answer((command.equals("E") ? "e," + speeds : answers.apply(command)) + "\r\n");
        if (command.equals("D,0,0") && moving.getCount() == 0) {
            standing.countDown();
        } else if (command.startsWith("D") && !command.equals("D,0,0")) {
            moving.countDown();
            if (isPulledWhenItMoves) {
                pull();
            }
        }
    }

    private void answer(String line) {
        written.addAndGet(line.length());
        plug.write(line);
    }

    private static String stock(String command) {
        return switch (command) {
            case "B" -> "b,HemiOS_v_1.50";
            case "I" -> "i,1,1,1,1";
            case "N" -> "n,004,004,004,004,004,004,060,060";
            case "O" -> "o,220,220,220,220,220,220,220,220";
            case "T" -> "t,000";
            case "J" -> "j";
            case "R,C0,10,01" -> "r,255";
            default -> command.startsWith("D") ? "d" : "Unknown Command ?!";
        };
    }

    private static String roadNarrows(String command) {
        return switch (command) {
            case "B" -> "b,HemiOS_v_1.50-RNe";
            case "I", "N", "O" -> stock(command);
            case "J" -> "j,U,E0,06,L,C0,01";
            default -> roadNarrowsModule(command);
        };
    }

    private static String roadNarrowsModule(String command) {
        return switch (command) {
            case "A,U,U,C" -> "a,U,U,C";
            case "A,U,M" -> "a,U,M";
            case "A,U,A" -> "a,U,A,0020,0041" + ",0000".repeat(15);
            case "A,L,P,0" -> "a,L,P,0," + "00FF".repeat(51);
            default -> command.startsWith("D") ? "d" + command.substring(1) : "<E01: unknown command>";
        };
    }
}
