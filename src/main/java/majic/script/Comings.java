package majic.script;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentHashMap;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Member;

/** Robots join and leave the team here. Both block for as long as the robot takes. Thread-safe. */
final class Comings {
    private final Session session;
    private final Map<Integer, String> addresses = new ConcurrentHashMap<>();

    Comings(Session session) {
        this.session = session;
    }

    /**
     * Connects to a robot and takes it in; says so. One that is here under just this number and address stays as it is,
     * so that a saved session can be done again by the team that did it.
     *
     * @throws BotException if it cannot be reached or taken in; nothing is left open
     */
    Member add(String address, OptionalInt number) {
        Optional<Member> there = alreadyThere(address, number);
        if (there.isPresent()) {
            session.say(Line.Kind.ANSWER, there.get().number() + ": at " + address + ", connected already");
            return there.get();
        }
        session.team().checkRoom(number);
        MajicBot bot = session.factory().create(address);
        connect(bot, address);
        Member member = join(bot, number);
        joined(member, address);
        return member;
    }

    /** The robot that is connected under just this number and address. */
    Optional<Member> alreadyThere(String address, OptionalInt number) {
        return session.team().members().stream()
                .filter(member -> number.isPresent() && number.getAsInt() == member.number())
                .filter(member -> address.equalsIgnoreCase(addresses.get(member.number())))
                .filter(member -> member.bot().isConnected())
                .findFirst();
    }

    /** Says and keeps that a robot was taken in. */
    void joined(Member member, String address) {
        addresses.put(member.number(), address);
        String label = member.bot().type().label();
        session.say(Line.Kind.ANSWER, member.number() + ": " + label + " at " + address + " connected");
        session.record().added(address, member.number());
    }

    private static void connect(MajicBot bot, String address) {
        try {
            bot.connect();
        } catch (BotException e) {
            bot.close();
            throw new BotException(address + ": " + bot.type().adviceAfter(String.valueOf(e.getMessage())), e);
        }
    }

    private Member join(MajicBot bot, OptionalInt number) {
        try {
            return session.team().add(bot, number);
        } catch (BotException e) {
            bot.close();
            throw e;
        }
    }

    /** Stops a robot, closes it and lets it go; the session says so. */
    void remove(Member member) {
        session.team().remove(member.number());
        addresses.remove(member.number());
        session.record().removed(member.number());
    }

    /** Where a robot was found. */
    Optional<String> address(Member member) {
        return Optional.ofNullable(addresses.get(member.number()));
    }
}
