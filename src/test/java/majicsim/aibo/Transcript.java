package majicsim.aibo;

import java.util.ArrayList;
import java.util.List;

/** A recorded session: what was sent, and the lines that stand below it, without time stamps and connection numbers. */
record Transcript(List<Exchange> exchanges) {
    /** One line that was sent, and what the record shows before the next was sent: late answers stand further down. */
    record Exchange(String sent, List<String> received) {
        /** With nothing sent: its own answers, which have no tag, are gone, late ones of commands before it stay. */
        Exchange leftOut() {
            return new Exchange(
                    "",
                    received.stream()
                            .filter(line -> !line.startsWith("[notag]"))
                            .toList());
        }
    }

    /** The sessions of a record; each begins with the banner, which is left out, or with a line {@code ==}. */
    static List<Transcript> parse(List<String> lines) {
        List<Transcript> sessions = new ArrayList<>();
        boolean inBanner = false;
        for (String line : lines) {
            boolean banner = line.contains(":start] ") || line.startsWith("==");
            if (banner && !inBanner) {
                sessions.add(new Transcript(new ArrayList<>()));
            } else if (line.startsWith("> ")) {
                sessions.get(sessions.size() - 1).exchanges().add(new Exchange(line.substring(2), new ArrayList<>()));
            } else if (!banner && !line.contains(":ident] ") && !line.contains(":power] ") && line.startsWith("< ")) {
                List<Exchange> exchanges = sessions.get(sessions.size() - 1).exchanges();
                exchanges.get(exchanges.size() - 1).received().add(plain(line.substring(2)));
            }
            inBanner = banner;
        }
        return sessions;
    }

    /** Without the time stamp and with every connection called U. */
    static String plain(String line) {
        return line.replaceFirst("^\\[\\d{8,}:", "[")
                .replaceAll("U\\d{9,}", "U")
                .stripTrailing();
    }
}
