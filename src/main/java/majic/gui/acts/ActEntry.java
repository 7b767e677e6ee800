package majic.gui.acts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.act.ActDetails;
import majic.act.Role;
import majic.bot.BotException;
import majic.script.ActOffer;
import majic.script.ActOffers;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * An act in a list to choose from.
 *
 * @param name the name shown in the list
 * @param offer the act; null if the file is not a valid act
 * @param note whether it contains code and how the code is signed, or what is wrong with the file
 */
record ActEntry(String name, @Nullable ActOffer offer, String note) {
    /** Reads the act of this name; may block. */
    static ActEntry read(ActOffers offers, String called) {
        try {
            ActOffer offer = offers.find(called);
            return new ActEntry(offer.details().name(), offer, note(offers, offer));
        } catch (BotException e) {
            return new ActEntry(called, null, String.valueOf(e.getMessage()));
        }
    }

    /** Reads all acts that can be loaded without a path; may block. */
    static List<ActEntry> readAll(ActOffers offers) {
        List<ActEntry> entries = new ArrayList<>();
        offers.names().forEach(name -> entries.add(read(offers, name)));
        return entries;
    }

    private static String note(ActOffers offers, ActOffer offer) {
        if (offers.needsConsent(offer)) {
            return "It contains code without your consent so far; MAJIC will ask for it.";
        }
        if (offer.file() == null || !offer.file().carriesCode()) {
            return "It contains data only, no code.";
        }
        return offer.file().isShipped() ? "It is part of MAJIC." : "Its code has your consent.";
    }

    /** Returns why a robot cannot run the act, as sentences; empty if it can. */
    Optional<String> unfit(Member member) {
        return offer == null ? Optional.of(note) : RoleFit.unfit(offer.roles().get(0), member);
    }

    /** Returns version and author, as far as they are given. */
    String origin() {
        if (offer == null) {
            return "";
        }
        ActDetails details = offer.details();
        String version = details.version().isEmpty() ? "" : "version " + details.version();
        String author = details.author().isEmpty() ? "" : "by " + details.author();
        return (version + " " + author).strip();
    }

    /** Describes the act's purpose and the robots it takes. */
    String description() {
        if (offer == null) {
            return "";
        }
        List<String> lines = new ArrayList<>();
        if (!offer.details().description().isEmpty()) {
            lines.add(offer.details().description() + "\n");
        }
        for (Role role : offer.roles()) {
            lines.add((role.name().equals(Role.ME) ? "Runs on: " : "Further robot, " + role.name() + ": ")
                    + RoleFit.wanted(role));
        }
        return String.join("\n", lines);
    }

    @Override
    public String toString() {
        return name;
    }
}
