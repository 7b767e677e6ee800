package majic.gui.acts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.act.Role;
import majic.bot.BotException;
import majic.script.ActOffer;
import majic.script.ActOffers;
import majic.team.Member;
import majic.text.ErrorWords;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * An act in a list to choose from.
 *
 * @param name the name shown in the list
 * @param offer the act; null if the file is not a valid act
 * @param note whether it contains code and how the code is signed, or what is wrong with the file
 */
record ActEntry(String name, @Nullable ActOffer offer, String note) {
    private static final Texts TEXTS = Texts.of(ActEntry.class);
    /** Reads the act of this name; may block. */
    static ActEntry read(ActOffers offers, String called) {
        try {
            ActOffer offer = offers.find(called);
            return new ActEntry(offer.details().name(), offer, note(offers, offer));
        } catch (BotException e) {
            return new ActEntry(called, null, ErrorWords.of(String.valueOf(e.getMessage())));
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
            return TEXTS.get("note.needsConsent");
        }
        if (offer.file() == null || !offer.file().carriesCode()) {
            return TEXTS.get("note.dataOnly");
        }
        return TEXTS.get(offer.file().isShipped() ? "note.shipped" : "note.consent");
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
        String version = offer.details().version();
        String author = offer.details().author();
        if (version.isEmpty()) {
            return author.isEmpty() ? "" : TEXTS.get("author", author);
        }
        return author.isEmpty() ? TEXTS.get("version", version) : TEXTS.get("versionAndAuthor", version, author);
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
            String wanted = RoleFit.wanted(role);
            lines.add(
                    role.name().equals(Role.ME)
                            ? TEXTS.get("runsOn", wanted)
                            : TEXTS.get("furtherRobot", role.name(), wanted));
        }
        return String.join("\n", lines);
    }

    @Override
    public String toString() {
        return name;
    }
}
