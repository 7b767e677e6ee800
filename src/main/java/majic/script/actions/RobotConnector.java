package majic.script.actions;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.MajicBot;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.record.SessionRecord;
import majic.script.run.SessionState;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** Adds robots to the team and removes them. Both block for as long as the robot takes. Thread-safe. */
public final class RobotConnector {
    /** How long {@code add} waits for an attempt that has begun already; longer than any driver tries, seconds. */
    private static final double CONNECTING_S = 30;

    private final Team team;
    private final BotFactory factory;
    private final SessionOutput output;
    private final SessionRecord record;
    private final Map<Integer, String> addresses = new ConcurrentHashMap<>();

    public RobotConnector(SessionState state, BotFactory factory) {
        this.team = state.team();
        this.factory = factory;
        this.output = state.output();
        this.record = state.record();
    }

    /**
     * Connects to a robot, adds it to the team and answers. One whose link is lost is connected again under the number
     * it has. One that is here under just this number and address stays as it is, so that a saved session can be done
     * again by the team that did it.
     *
     * @throws BotException if it cannot be reached or taken in; nothing new is left open
     */
    Member add(String address, OptionalInt number) {
        try {
            return addOrConnect(address, number);
        } catch (BotException e) {
            if (e.getCause() instanceof ConnectFailed failed && failed.reason() == ConnectFailed.Reason.WRONG_LOGIN) {
                String as = number.isPresent() ? " as " + number.getAsInt() : "";
                output.loginRefused(address, "add " + address + as);
            }
            throw e;
        }
    }

    private Member addOrConnect(String address, OptionalInt number) {
        Optional<Member> there = alreadyThere(address, number).or(() -> connectedMeanwhile(address, number));
        if (there.isPresent()) {
            output.send(Line.Kind.ANSWER, there.get().number() + ": at " + address + ", connected already");
            return there.get();
        }
        Optional<Member> lost = lost(address, number);
        if (lost.isPresent()) {
            connect(lost.get().bot(), address);
            return lost.get();
        }
        team.checkRoom(number);
        checkUnused(address);
        MajicBot bot = factory.create(address);
        connectNew(bot, address);
        Member member = joinOnce(bot, address, number);
        joined(member, address);
        return member;
    }

    /** Takes a robot in that only the connection shows to be another one than those of the team: one at a time. */
    private Member joinOnce(MajicBot bot, String address, OptionalInt number) {
        synchronized (addresses) {
            try {
                checkIdentity(bot, address);
            } catch (BotException e) {
                bot.close();
                throw e;
            }
            return join(bot, number);
        }
    }

    /** Two robots of the team would command one device, of which the addresses differ. */
    private void checkIdentity(MajicBot bot, String address) {
        Optional<Member> there = team.members().stream()
                .filter(member -> member.bot() != bot)
                .filter(member ->
                        bot.identity().isPresent() && member.bot().identity().equals(bot.identity()))
                .findFirst();
        if (there.isPresent()) {
            Member same = there.get();
            if (same.bot().isConnected()) {
                throw connectedAlready(address, same, null);
            }
            throw new BotException(address + ": it is robot " + same.number()
                    + ", whose connection was lost; type \"add " + address(same).orElse(address)
                    + "\" to connect it again");
        }
    }

    /**
     * Checks that a robot can be added: it needs no new number if it is in the team already, connected or not.
     *
     * @throws BotException if the number is taken or the team is full
     */
    void checkRoom(String address, OptionalInt number) {
        boolean isHere = Stream.of(alreadyThere(address, number), lost(address, number), connecting(address, number))
                .anyMatch(Optional::isPresent);
        if (!isHere) {
            team.checkRoom(number);
        }
    }

    /**
     * Checks that no robot of the team is connected at an address: some devices, such as an Aibo, accept several
     * connections, and two robots of the team would command one device.
     *
     * @throws BotException naming the robot that is
     */
    public void checkUnused(String address) {
        Optional<Member> there =
                at(address).filter(member -> member.bot().isConnected()).findFirst();
        if (there.isPresent()) {
            throw connectedAlready(address, there.get(), null);
        }
    }

    private static BotException connectedAlready(String address, Member there, @Nullable BotException cause) {
        return new BotException(address + ": robot " + there.number() + " is connected to it already", cause);
    }

    /** The robot that is connected under just this number and address. */
    private Optional<Member> alreadyThere(String address, OptionalInt number) {
        return drivenAt(address)
                .filter(member -> number.isPresent() && number.getAsInt() == member.number())
                .filter(member -> member.bot().isConnected())
                .findFirst();
    }

    /** The robot at this address that has lost its link; under this number, if one is given. */
    public Optional<Member> lost(String address, OptionalInt number) {
        return here(address, number, MajicBot.Connection.LOST);
    }

    /** The robot at this address that is being connected again; under this number, if one is given. */
    public Optional<Member> connecting(String address, OptionalInt number) {
        return here(address, number, MajicBot.Connection.CONNECTING);
    }

    /** Waits for an attempt to connect the robot again that has begun already; empty if there is none or it fails. */
    private Optional<Member> connectedMeanwhile(String address, OptionalInt number) {
        Optional<Member> connecting = connecting(address, number);
        try {
            team.changes().await(() -> connecting(address, number).isEmpty(), CONNECTING_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return connecting.filter(member -> member.bot().isConnected());
    }

    private Optional<Member> here(String address, OptionalInt number, MajicBot.Connection connection) {
        return drivenAt(address)
                .filter(member -> number.isEmpty() || number.getAsInt() == member.number())
                .filter(member -> member.bot().connection() == connection)
                .findFirst();
    }

    /** The robots at an address that are driven by the library and the parameter file it names, or by none. */
    private Stream<Member> drivenAt(String address) {
        return at(address)
                .filter(member ->
                        address(member).map(BotFactory::drivenBy).equals(Optional.of(BotFactory.drivenBy(address))));
    }

    private Stream<Member> at(String address) {
        return team.members().stream()
                .filter(member -> address(member)
                        .filter(used -> factory.isSameRobot(address, used))
                        .isPresent());
    }

    /** Answers and records that a robot was added. */
    public void joined(Member member, String address) {
        addresses.put(member.number(), address);
        String label = member.label();
        output.send(Line.Kind.ANSWER, member.number() + ": " + label + " at " + address + " connected");
        record.added(address, member.number());
    }

    private void connectNew(MajicBot bot, String address) {
        try {
            connect(bot, address);
        } catch (BotException e) {
            bot.close();
            Optional<Member> holder =
                    at(address).filter(member -> member.bot().isConnected()).findFirst();
            throw holder.map(member -> connectedAlready(address, member, e)).orElse(e);
        }
    }

    private static void connect(MajicBot bot, String address) {
        try {
            bot.connect();
        } catch (BotException e) {
            throw new BotException(address + ": " + bot.type().adviceAfter(String.valueOf(e.getMessage())), e);
        }
    }

    private Member join(MajicBot bot, OptionalInt number) {
        try {
            return team.add(bot, number);
        } catch (BotException e) {
            bot.close();
            throw e;
        }
    }

    /** Stops a robot, closes it and removes it from the team, which answers. */
    void remove(Member member) {
        boolean busy = !member.isIdle() || member.owner() != null;
        long atNanos = team.time().nanos();
        team.remove(member.number());
        addresses.remove(member.number());
        record.removed(member.number(), busy, atNanos);
    }

    /** Where a robot was found. */
    public Optional<String> address(Member member) {
        return Optional.ofNullable(addresses.get(member.number()));
    }
}
