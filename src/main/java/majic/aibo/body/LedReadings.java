package majic.aibo.body;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;

/**
 * Holds the brightness of the dog's LEDs and the position of its ears, polled only while the panel is shown.
 * Thread-safe.
 */
public final class LedReadings {
    private static final String SUFFIX = "_led";
    private static final Pattern TAG = Pattern.compile("\\w+" + SUFFIX + "(\\d{1,2})");
    private static final int PERIOD_MS = 480;
    private static final List<String> DEVICES =
            Stream.concat(LedNames.all().stream(), Stream.of("earL", "earR")).toList();

    private final Map<String, Double> amounts = new ConcurrentHashMap<>();

    /** Returns the command that makes the dog report them, until {@link #stop}. */
    public static String order(String tag, UrbiVersion version) {
        String readings = DEVICES.stream()
                .map(device -> version.labelled(tag + SUFFIX + DEVICES.indexOf(device), device + ".val"))
                .collect(Collectors.joining(" & "));
        return tag + ": every(" + PERIOD_MS + ") { " + readings + " },";
    }

    public static String stop(String tag) {
        return "stop " + tag + ",";
    }

    /** Takes a message if it reports one of them; returns whether it does. */
    public boolean take(UrbiMessage message) {
        Matcher tag = TAG.matcher(message.tag());
        int index = tag.matches() ? Integer.parseInt(tag.group(1)) : DEVICES.size();
        if (index >= DEVICES.size()) {
            return false;
        }
        if (message.body() instanceof UrbiMessage.Result result
                && result.value() instanceof UrbiValue.Num number
                && Double.isFinite(number.amount())) {
            amounts.put(DEVICES.get(index), number.amount());
        }
        return true;
    }

    /** Forgets all, as when the dog is another one. */
    void clear() {
        amounts.clear();
    }

    /** How brightly an LED shines, 0 to 1; 1 for an ear that is flicked; empty before the dog has reported it. */
    public Optional<Double> amount(String device) {
        return Optional.ofNullable(amounts.get(device));
    }

    /** Adds each amount by the name of its device. */
    void addTexts(Map<String, String> texts) {
        amounts.forEach((device, amount) -> texts.put(device, String.valueOf(Math.round(amount * 100) / 100.0)));
    }

    /** Takes the amounts that {@link #addTexts} has written. */
    void restore(Map<String, String> texts) {
        for (String device : DEVICES) {
            String text = texts.get(device);
            if (text != null) {
                amounts.put(device, Double.parseDouble(text));
            }
        }
    }
}
