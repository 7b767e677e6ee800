package majic.script.run;

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
    private final Map<Integer, Place> places = new ConcurrentHashMap<>();

    /**
     * Where a robot was connected.
     *
     * @param address as it was typed
     * @param device what identified the device there; empty if the system does not identify it
     */
    private record Place(String address, String device) {}

    public RobotConnector(Team team, BotFactory factory, SessionOutput output, SessionRecord record) {
        this.team = team;
        this.factory = factory;
        this.output = output;
        this.record = record;
    }

    /**
     * Connects to a robot, adds it to the team and answers. One whose link is lost is connected again under the number
     * it has. One that is here under just this number and address stays as it is, so that a saved session can be done
     * again by the team that did it.
     *
     * @throws BotException if it cannot be reached or taken in; nothing new is left open
     */
    public Member add(String address, OptionalInt number) {
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
        String device = factory.deviceAt(address);
        Optional<Member> there =
                alreadyThere(address, device, number).or(() -> connectedMeanwhile(address, device, number));
        if (there.isPresent()) {
            output.send(Line.Kind.ANSWER, there.get().number() + ": at " + address + ", connected already");
            return there.get();
        }
        Optional<Member> lost = here(address, device, number, MajicBot.Connection.LOST);
        Optional<Member> replaced = lostUnder(number);
        if (lost.isPresent() && connectAgain(lost.get(), address, replaced.isPresent())) {
            return lost.get();
        }
        if (replaced.isEmpty()) {
            team.checkRoom(number);
        }
        checkUnused(address);
        MajicBot bot = factory.create(address);
        replaced.ifPresent(old -> checkType(old, bot));
        connectNew(bot, address);
        String name = replaced.map(Member::name).orElse("");
        Member member = joinOnce(bot, address, number, replaced);
        if (!name.isEmpty()) {
            team.rename(member, name);
        }
        joined(member, address);
        return member;
    }

    /** Takes a robot in that only the connection shows to be another one than those of the team: one at a time. */
    private Member joinOnce(MajicBot bot, String address, OptionalInt number, Optional<Member> replaced) {
        synchronized (places) {
            try {
                checkIdentity(bot, address, replaced);
            } catch (BotException e) {
                bot.close();
                throw e;
            }
            replaced.ifPresent(old -> replace(old, address));
            return join(bot, number);
        }
    }

    /** Two robots of the team would command one device, of which the addresses differ. */
    private void checkIdentity(MajicBot bot, String address, Optional<Member> replaced) {
        Optional<Member> there = team.members().stream()
                .filter(member -> member.bot() != bot && member != replaced.orElse(null))
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
     * Connects a robot that has lost its connection. Another adapter in its place is taken if the user gave the number.
     *
     * @return false if the robot has to be replaced for that
     */
    private boolean connectAgain(Member member, String address, boolean replaceable) {
        places.computeIfPresent(member.number(), (number, before) -> new Place(address, before.device()));
        try {
            connect(member.bot(), address);
            return true;
        } catch (BotException e) {
            if (replaceable
                    && e.getCause() instanceof ConnectFailed failed
                    && failed.reason() == ConnectFailed.Reason.OTHER_ADAPTER) {
                return false;
            }
            throw e;
        }
    }

    /** The robot with a number that was given, if its connection is lost. */
    private Optional<Member> lostUnder(OptionalInt number) {
        return team.members().stream()
                .filter(member -> number.isPresent() && number.getAsInt() == member.number())
                .filter(member -> member.bot().connection() == MajicBot.Connection.LOST)
                .findFirst();
    }

    private static void checkType(Member old, MajicBot bot) {
        if (!old.bot().type().name().equals(bot.type().name())) {
            throw new BotException(old.number() + ": there is a robot " + old.number() + " already, of another type ("
                    + old.bot().type().label() + "); remove it first");
        }
    }

    private void replace(Member old, String address) {
        String before = address(old).map(where -> "the robot at " + where).orElse("it");
        remove(old);
        output.send(
                Line.Kind.NOTICE,
                old.number() + ": the robot at " + address + " takes the number of " + before
                        + ", whose connection was lost; if that is another robot, nothing stops it now");
    }

    /**
     * Checks that a robot can be added: it needs no new number if it is in the team already, connected or not.
     *
     * @throws BotException if the number is taken or the team is full
     */
    public void checkRoom(String address, OptionalInt number) {
        boolean isHere = Stream.of(
                        alreadyThere(address, "", number),
                        here(address, "", number, MajicBot.Connection.LOST),
                        lostUnder(number),
                        here(address, "", number, MajicBot.Connection.CONNECTING))
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
    private Optional<Member> alreadyThere(String address, String device, OptionalInt number) {
        return drivenAt(address, device)
                .filter(member -> number.isPresent() && number.getAsInt() == member.number())
                .filter(member -> member.bot().isConnected())
                .findFirst();
    }

    /** The robot at this address that has lost its link; under this number, if one is given. */
    public Optional<Member> lost(String address, OptionalInt number) {
        return here(address, factory.deviceAt(address), number, MajicBot.Connection.LOST);
    }

    /** The robot at this address that is being connected again; under this number, if one is given. */
    public Optional<Member> connecting(String address, OptionalInt number) {
        return here(address, factory.deviceAt(address), number, MajicBot.Connection.CONNECTING);
    }

    /** Waits for an attempt to connect the robot again that has begun already; empty if there is none or it fails. */
    private Optional<Member> connectedMeanwhile(String address, String device, OptionalInt number) {
        Optional<Member> connecting = here(address, device, number, MajicBot.Connection.CONNECTING);
        try {
            team.changes()
                    .await(
                            () -> connecting
                                    .filter(member -> member.bot().connection() == MajicBot.Connection.CONNECTING)
                                    .isEmpty(),
                            CONNECTING_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return connecting.filter(member -> member.bot().isConnected());
    }

    private Optional<Member> here(String address, String device, OptionalInt number, MajicBot.Connection connection) {
        return drivenAt(address, device)
                .filter(member -> number.isEmpty() || number.getAsInt() == member.number())
                .filter(member -> member.bot().connection() == connection)
                .findFirst();
    }

    /** The robots at an address that are driven by the library and the parameter file it names, or by none. */
    private Stream<Member> drivenAt(String address, String device) {
        return at(address, device)
                .filter(member ->
                        address(member).map(BotFactory::drivenBy).equals(Optional.of(BotFactory.drivenBy(address))));
    }

    private Stream<Member> at(String address) {
        return at(address, factory.deviceAt(address));
    }

    private Stream<Member> at(String address, String device) {
        return team.members().stream().filter(member -> isAt(places.get(member.number()), address, device));
    }

    /** Two devices that the system identifies are compared, since their names may have changed; others by address. */
    private boolean isAt(@Nullable Place place, String address, String device) {
        if (place == null) {
            return false;
        }
        return device.isEmpty() || place.device().isEmpty()
                ? factory.isSameRobot(address, place.address())
                : device.equals(place.device());
    }

    /** Answers and records that a robot was added. */
    public void joined(Member member, String address) {
        place(member, address);
        String label = member.label();
        output.send(Line.Kind.ANSWER, member.number() + ": " + label + " at " + address + " connected");
        record.added(address, member.number());
    }

    private void place(Member member, String address) {
        places.put(member.number(), new Place(address, factory.deviceAt(address)));
    }

    private void connectNew(MajicBot bot, String address) {
        try {
            connect(bot, address);
        } catch (BotException e) {
            bot.close();
            throw explained(address, e);
        }
    }

    /** Why an attempt to connect failed: often because a robot of the team is connected there. */
    public BotException explained(String address, BotException failure) {
        return at(address)
                .filter(member -> member.bot().isConnected())
                .findFirst()
                .map(member -> connectedAlready(address, member, failure))
                .orElse(failure);
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
    public void remove(Member member) {
        boolean busy = !member.isIdle() || member.owner() != null;
        long atNanos = team.time().nanos();
        team.remove(member.number());
        places.remove(member.number());
        record.removed(member.number(), busy, atNanos);
    }

    /** Where a robot was found. */
    public Optional<String> address(Member member) {
        return Optional.ofNullable(places.get(member.number())).map(Place::address);
    }
}
