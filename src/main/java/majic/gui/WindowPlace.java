package majic.gui;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The place of a window and of its dividers, in the form that is kept in the settings: {@code 100 50 1280 800 normal
 * 640 520}. Immutable.
 *
 * @param bounds place and size while it is not maximised, pixels
 * @param maximised whether it fills the screen
 * @param dividers the places of the dividers, pixels
 */
record WindowPlace(Rectangle bounds, boolean maximised, List<Integer> dividers) {
    private static final Pattern FORM = Pattern.compile("(-?\\d{1,5} ){2}(\\d{1,5} ){2}(normal|maximised)( \\d{1,5})*");

    WindowPlace {
        bounds = new Rectangle(bounds);
        dividers = List.copyOf(dividers);
    }

    /** Reads the kept form; empty if it is damaged. */
    static Optional<WindowPlace> parse(String text) {
        if (!FORM.matcher(text).matches()) {
            return Optional.empty();
        }
        String[] words = text.split(" ");
        List<Integer> dividers = new ArrayList<>();
        for (int index = 5; index < words.length; index++) {
            dividers.add(Integer.parseInt(words[index]));
        }
        Rectangle bounds = new Rectangle(
                Integer.parseInt(words[0]),
                Integer.parseInt(words[1]),
                Integer.parseInt(words[2]),
                Integer.parseInt(words[3]));
        return Optional.of(new WindowPlace(bounds, words[4].equals("maximised"), dividers));
    }

    @Override
    public Rectangle bounds() {
        return new Rectangle(bounds);
    }

    /** Returns the place of a divider; empty if it was not kept. */
    Optional<Integer> divider(int index) {
        return index < dividers.size() ? Optional.of(dividers.get(index)) : Optional.empty();
    }

    @Override
    public String toString() {
        String places = dividers.stream().map(place -> " " + place).collect(Collectors.joining());
        return bounds.x + " " + bounds.y + " " + bounds.width + " " + bounds.height + " "
                + (maximised ? "maximised" : "normal") + places;
    }
}
