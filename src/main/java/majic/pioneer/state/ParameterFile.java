package majic.pioneer.state;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import majic.bot.BotException;
import majic.file.RegularFile;
import org.jspecify.annotations.Nullable;

/**
 * The maker's parameter file of one robot ({@code .p}), as ARIA has them: lines of a keyword and its values, with
 * comments behind semicolons. The factors, sizes, top speeds, bumpers and sonars are read; all other lines are ignored.
 * Immutable.
 */
public final class ParameterFile {
    private static final int MOST_BYTES = 1 << 20;
    private static final String SCALE = "DistConvFactor";
    private static final String SONAR = "SonarUnit";
    private static final int SONAR_VALUES = 4;

    /** Segments of a bumper of which only the presence is known (ARCOS sheet 12). */
    private static final int USUAL_BUMPERS = 5;

    /** The keywords with one number, and its limits. */
    private static final Map<String, Limit> NUMBERS = Map.ofEntries(
            number(SCALE, 1e-6, 100),
            number("AngleConvFactor", 1e-6, 0.1),
            number("VelConvFactor", 1e-6, 100),
            number("RangeConvFactor", 1e-6, 100),
            number("DiffConvFactor", 1e-6, 1),
            number("RobotWidth", 1, 10_000),
            number("RobotLength", 1, 10_000),
            number("RobotLengthFront", 0, 10_000),
            number("RobotLengthRear", 0, 10_000),
            number("MaxVelocity", 0, 10_000),
            number("MaxRVelocity", 0, 1000),
            number("NumFrontBumpers", 0, 7),
            number("NumRearBumpers", 0, 7));

    private final Map<String, Double> numbers = new HashMap<>();
    private final Map<String, String> words = new HashMap<>();
    private final Map<Integer, SonarDisc> sonars = new TreeMap<>();
    private boolean listsSonars;

    /** A keyword as the maker writes it, and the least and the greatest number behind it. */
    private record Limit(String keyword, double least, double greatest) {}

    /** One line, without its comment. */
    private record Line(Path file, int number, String[] words) {
        BotException wrong(String problem) {
            return new BotException(file + ", line " + number + ": " + problem);
        }

        double number(int index, Limit limit) {
            String word = index < words.length ? words[index] : "nothing";
            try {
                double value = Double.parseDouble(word);
                if (value >= limit.least && value <= limit.greatest) {
                    return value;
                }
            } catch (NumberFormatException e) {
                // Reported below, as a number out of range is.
            }
            throw wrong(words[0] + " needs a number from " + text(limit.least) + " to " + text(limit.greatest)
                    + ", not " + word);
        }

        private static String text(double number) {
            return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
        }
    }

    private ParameterFile() {}

    private static Map.Entry<String, Limit> number(String keyword, double least, double greatest) {
        return Map.entry(keyword.toLowerCase(Locale.ROOT), new Limit(keyword, least, greatest));
    }

    /**
     * Reads a file.
     *
     * @throws BotException if it cannot be read, a line in it is wrong, or the scale is missing; the message names the
     *     file and the line
     */
    public static ParameterFile read(Path path) {
        ParameterFile file = new ParameterFile();
        String[] lines = text(path).split("\\R", -1);
        for (int index = 0; index < lines.length; index++) {
            String plain = lines[index].replaceFirst(";.*", "").strip();
            if (!plain.isEmpty()) {
                file.take(new Line(path, index + 1, plain.split("\\s+")));
            }
        }
        if (!file.has(SCALE)) {
            throw new BotException(path + ": has no line such as \"" + SCALE
                    + " 0.485\", the mm of one count; is it the parameter file of a robot?");
        }
        return file;
    }

    private static String text(Path path) {
        try {
            return new String(RegularFile.read(path, MOST_BYTES), StandardCharsets.ISO_8859_1);
        } catch (NoSuchFileException e) {
            throw new BotException(path + ": there is no such parameter file", e);
        } catch (IOException e) {
            throw new BotException(path + ": the parameter file cannot be read: " + e.getMessage(), e);
        }
    }

    private void take(Line line) {
        String keyword = line.words[0].toLowerCase(Locale.ROOT);
        Limit limit = NUMBERS.get(keyword);
        if (limit != null) {
            numbers.put(keyword, line.number(1, limit));
        } else if (keyword.equalsIgnoreCase(SONAR)) {
            takeSonar(line);
        } else if (keyword.equals("sonarnum")) {
            listsSonars = true;
        } else if (line.words.length > 1) {
            words.put(keyword, line.words[1]);
        }
    }

    /** A disc at the centre is a number that is not in use. */
    private void takeSonar(Line line) {
        if (line.words.length <= SONAR_VALUES) {
            throw line.wrong(SONAR + " needs the number of the disc, x mm, y mm and degrees, as in \"" + SONAR
                    + " 0 69 136 90\"");
        }
        int disc = (int) line.number(1, new Limit(SONAR, 0, SonarScan.DISCS - 1));
        double x = line.number(2, new Limit(SONAR, -10_000, 10_000));
        double y = line.number(3, new Limit(SONAR, -10_000, 10_000));
        double axis = line.number(SONAR_VALUES, new Limit(SONAR, -360, 360));
        listsSonars = true;
        if (x != 0 || y != 0) {
            sonars.put(disc, new SonarDisc(disc, x, y, axis));
        }
    }

    private boolean has(String keyword) {
        return numbers.containsKey(keyword.toLowerCase(Locale.ROOT));
    }

    private double number(String keyword, double otherwise) {
        return numbers.getOrDefault(keyword.toLowerCase(Locale.ROOT), otherwise);
    }

    /** The number of a keyword; zero means that the file does not tell. */
    private double positive(String keyword, double otherwise) {
        double given = number(keyword, 0);
        return given > 0 ? given : otherwise;
    }

    /** The model that the file is for; empty if it does not tell. */
    public Optional<String> subclass() {
        return Optional.ofNullable(words.get("subclass"));
    }

    /** The model that a robot announces, with the values of this file where it has some. */
    public Model model(String announced) {
        Model base = Models.of(announced);
        List<SonarDisc> discs = listsSonars ? List.copyOf(sonars.values()) : base.discs();
        return new Model(
                base.subclass(),
                true,
                hull(base.hull()),
                discs,
                scaling(base.known() ? base.scaling() : Scaling.CURRENT),
                positive("MaxVelocity", base.topSpeedMmPerSec()),
                positive("MaxRVelocity", base.topTurnDegPerSec()),
                bumpers("Front", base.frontBumpers()),
                bumpers("Rear", base.rearBumpers()));
    }

    private Scaling scaling(Scaling base) {
        return new Scaling(
                number(SCALE, base.mmPerCount()),
                has("AngleConvFactor") ? Scaling.degPerCount(number("AngleConvFactor", 0)) : base.degPerCount(),
                number("VelConvFactor", base.mmPerSecPerCount()),
                number("RangeConvFactor", base.mmPerRangeCount()),
                number("DiffConvFactor", base.radPerMm()));
    }

    /** Without its front and its rear the robot turns about its middle. */
    private Hull hull(Hull base) {
        double length = number("RobotLength", base.frontMm() + base.rearMm());
        double front = positive("RobotLengthFront", has("RobotLength") ? length / 2 : base.frontMm());
        return new Hull(
                front,
                positive("RobotLengthRear", Math.max(0, length - front)),
                number("RobotWidth", 2 * base.halfWidthMm()) / 2);
    }

    /** {@code FrontBumpers true} alone means as many as usual. */
    private int bumpers(String end, int otherwise) {
        @Nullable String fitted = words.get((end + "Bumpers").toLowerCase(Locale.ROOT));
        if (fitted == null) {
            return otherwise;
        }
        return Boolean.parseBoolean(fitted) ? (int) number("Num" + end + "Bumpers", USUAL_BUMPERS) : 0;
    }
}
