package majic.nav.file;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import majic.bot.Pose;
import majic.file.WholeFile;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;

/**
 * The maps of ROS's map_server: a YAML file with {@code image}, {@code resolution} (m a cell), {@code origin} (m, m,
 * rad: the lower left corner), {@code negate}, {@code occupied_thresh}, {@code free_thresh} and {@code mode} (trinary
 * or scale), and a picture beside it, PGM (P5 or P2) or PNG. A pixel p is occupied with (255 - p) / 255, or p / 255 if
 * negated. The first row of the picture is the top of the map. Places and forbidden lines stand under keys of their
 * own, which other readers pass over.
 *
 * <p>The YAML file has at most {@value #MOST_LINES} lines, the picture as many pixels as a grid can have cells.
 */
final class MapServerFile {
    private static final int MOST_LINES = 100_000;
    private static final double FULL = 255;
    private static final double FAR_M = 1e6;
    private static final double MM = 1000;
    private static final int LONGEST_LIST = 200;
    private static final int UNKNOWN_PIXEL = 205;
    private static final int FREE_PIXEL = 254;

    /** Lines of the YAML file that are neither places nor forbidden lines. */
    private static final int OTHER_LINES = 10;

    private static final String PLACES = "places";
    private static final Pattern PLACE =
            Pattern.compile("- \\{name: \"([^\"\\p{Cntrl}]+)\", x: ([-0-9.]+), y: ([-0-9.]+)(?:, yaw: ([-0-9.]+))?\\}");
    private static final String FORBIDDEN = "forbidden_lines";
    private static final Pattern LINE =
            Pattern.compile("- \\{x1: ([-0-9.]+), y1: ([-0-9.]+), x2: ([-0-9.]+), y2: ([-0-9.]+)\\}");

    private final Map<String, String> values = new HashMap<>();
    private final Map<String, Integer> numbers = new HashMap<>();
    private final List<NavigationMap.Place> places = new ArrayList<>();
    private final List<NavigationMap.ForbiddenLine> forbidden = new ArrayList<>();
    private final String name;

    private MapServerFile(Path file) throws IOException {
        name = NumberedLines.name(file);
        try (NumberedLines lines = NumberedLines.open(file, MOST_LINES)) {
            String list = "";
            for (String line = lines.next(); line != null; line = lines.next()) {
                String text = line.replaceFirst("(^|\\s)#.*$", "").strip();
                int colon = text.indexOf(':');
                if (list.equals(PLACES) && line.strip().startsWith("- ")) {
                    places.add(place(line, lines));
                } else if (list.equals(FORBIDDEN) && text.startsWith("- ")) {
                    forbidden.add(forbiddenLine(text, lines));
                } else if (text.startsWith("- ") && !list.isEmpty()) {
                    values.merge(list, text.substring(2).strip(), MapServerFile::joined);
                } else if (colon > 0) {
                    list = text.substring(0, colon).strip();
                    values.put(list, text.substring(colon + 1).strip());
                    numbers.put(list, lines.number());
                } else if (!text.isEmpty() && !text.equals("---")) {
                    throw lines.wrong("'" + NumberedLines.shortened(text) + "' is not a key, a colon and a value");
                }
            }
        }
    }

    /** Joins the items of a list; those of a list that is longer than any of map_server's are left out. */
    private static String joined(String old, String more) {
        return old.isEmpty() ? more : old.length() < LONGEST_LIST ? old + "," + more : old;
    }

    static NavigationMap read(Path file) throws IOException {
        MapServerFile read = new MapServerFile(file);
        return new NavigationMap(read.grid(file), read.places, read.forbidden, Optional.empty());
    }

    private NavigationMap.Place place(String line, NumberedLines lines) throws IOException {
        Matcher item = PLACE.matcher(line.strip());
        if (!item.matches()) {
            throw lines.wrong("'" + NumberedLines.shortened(line.strip())
                    + "' is no place; - {name: \"desk\", x: 1.5, y: 0.3, yaw: 0} would be right (m, m, rad)");
        }
        String yaw = item.group(4);
        Pose pose = new Pose(
                number(PLACES, item.group(2), -FAR_M, FAR_M) * MM,
                number(PLACES, item.group(3), -FAR_M, FAR_M) * MM,
                yaw == null ? 0 : Math.toDegrees(number(PLACES, yaw, -7, 7)));
        return new NavigationMap.Place(item.group(1), pose, yaw != null);
    }

    private NavigationMap.ForbiddenLine forbiddenLine(String text, NumberedLines lines) throws IOException {
        Matcher item = LINE.matcher(text);
        if (!item.matches()) {
            throw lines.wrong("'" + NumberedLines.shortened(text)
                    + "' is no forbidden line; - {x1: 0, y1: 0, x2: 1.5, y2: 0.3} would be right (m)");
        }
        double[] ends = new double[4];
        for (int end = 0; end < ends.length; end++) {
            ends[end] = number(FORBIDDEN, item.group(end + 1), -FAR_M, FAR_M) * MM;
        }
        return new NavigationMap.ForbiddenLine(ends[0], ends[1], ends[2], ends[3]);
    }

    private OccupancyGrid grid(Path file) throws IOException {
        double resolution = number("resolution", value("resolution", "0.05 (m a cell)"), 0.001, 100);
        String[] origin = value("origin", "[0, 0, 0] (m, m, rad)")
                .replaceAll("[\\[\\]]", "")
                .strip()
                .split("\\s*,\\s*");
        if (origin.length != 3) {
            throw wrong("origin", "has to be [x, y, yaw] in m, m and rad");
        }
        Pose corner = new Pose(
                number("origin", origin[0], -FAR_M, FAR_M) * MM,
                number("origin", origin[1], -FAR_M, FAR_M) * MM,
                Math.toDegrees(number("origin", origin[2], -7, 7)));
        boolean negate = flag(value("negate", "0"));
        double occupied = number("occupied_thresh", value("occupied_thresh", "0.65"), 0, 1);
        double free = number("free_thresh", value("free_thresh", "0.196"), 0, 1);
        String mode = plain(values.getOrDefault("mode", "trinary"));
        if (!mode.equals("trinary") && !mode.equals("scale")) {
            throw wrong("mode", "is '" + NumberedLines.shortened(mode) + "', but has to be trinary or scale");
        }
        Picture picture = picture(file.resolveSibling(image()));
        return OccupancyGrid.of(corner, resolution * MM, picture.width(), picture.height(), (column, row) -> {
            double level = picture.grey(column, picture.height() - 1 - row) / FULL;
            double probability = negate ? level : 1 - level;
            if (probability > occupied) {
                return 1;
            }
            if (probability < free) {
                return 0;
            }
            return mode.equals("scale") ? probability : Double.NaN;
        });
    }

    private Path image() throws IOException {
        String image = plain(value("image", "office.pgm"));
        try {
            return Path.of(image);
        } catch (java.nio.file.InvalidPathException e) {
            throw wrong("image", "is '" + NumberedLines.shortened(image) + "', which is no name of a file");
        }
    }

    private static String plain(String text) {
        return text.replaceAll("^([\"'])(.*)\\1$", "$2");
    }

    private String value(String key, String example) throws IOException {
        String value = values.get(key);
        if (value == null || value.isEmpty()) {
            throw new IOException(name + ": " + key + " is missing, such as " + key + ": " + example);
        }
        return value;
    }

    private boolean flag(String text) throws IOException {
        return switch (text) {
            case "0", "false" -> false;
            case "1", "true" -> true;
            default -> throw wrong("negate", "is '" + NumberedLines.shortened(text) + "', but has to be 0 or 1");
        };
    }

    private double number(String key, String text, double least, double most) throws IOException {
        try {
            double value = Double.parseDouble(text);
            if (value >= least && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Refused below.
        }
        throw wrong(
                key,
                "has '" + NumberedLines.shortened(text) + "', but has to be a number from " + least + " to " + most);
    }

    private IOException wrong(String key, String what) {
        return new IOException(name + ", line " + numbers.getOrDefault(key, 1) + ": " + key + " " + what);
    }

    /** A picture of grey values of 0 to 255, the first row on top. */
    record Picture(int width, int height, byte[] pixels) {
        int grey(int column, int row) {
            return pixels[row * width + column] & 0xFF;
        }

        static void check(String name, long width, long height) throws IOException {
            if (width < 1
                    || height < 1
                    || width > OccupancyGrid.MOST_CELLS
                    || height > OccupancyGrid.MOST_CELLS
                    || width * height > OccupancyGrid.MOST_CELLS) {
                throw new IOException(name + ": the picture has " + width + " by " + height + " pixels; 1 to "
                        + OccupancyGrid.MOST_CELLS + " in all can be read");
            }
        }
    }

    private static Picture picture(Path file) throws IOException {
        String name = NumberedLines.name(file);
        try (InputStream in = new BufferedInputStream(NumberedLines.regular(file), 1 << 16)) {
            in.mark(2);
            int first = in.read();
            int second = in.read();
            if (first == 'P' && (second == '5' || second == '2')) {
                return PortableGraymap.read(in, name, second == '5');
            }
            in.reset();
            return png(in, name);
        }
    }

    private static Picture png(InputStream in, String name) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName("png");
        ImageReader reader = readers.next();
        ImageIO.setUseCache(false);
        try (ImageInputStream stream = ImageIO.createImageInputStream(in)) {
            reader.setInput(stream, true, true);
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            Picture.check(name, width, height);
            var image = reader.read(0);
            byte[] pixels = new byte[width * height];
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < width; x++) {
                    int rgb = image.getRGB(x, y);
                    pixels[y * width + x] = (byte) (((rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF)) / 3);
                }
            }
            return new Picture(width, height, pixels);
        } catch (IOException | RuntimeException e) {
            if (e instanceof IOException && String.valueOf(e.getMessage()).startsWith(name)) {
                throw e;
            }
            throw new IOException(name + " is no picture of a map: PGM (P5 or P2) or PNG would be right", e);
        } finally {
            reader.dispose();
        }
    }

    /** Writes both files, each as a whole; the picture is NAME.pgm beside NAME.yaml, P5. */
    static void write(Path yaml, NavigationMap map) throws IOException {
        OccupancyGrid grid = map.grid();
        if (map.places().size() + map.forbidden().size() > MOST_LINES - OTHER_LINES) {
            throw new IOException(NumberedLines.name(yaml) + ": the map has "
                    + map.places().size() + " places and " + map.forbidden().size() + " forbidden lines; up to "
                    + (MOST_LINES - OTHER_LINES) + " can be written");
        }
        String base = NumberedLines.name(yaml).replaceFirst("\\.ya?ml$", "");
        Path image = yaml.resolveSibling(base + ".pgm");
        WholeFile.replace(image, out -> {
            String head =
                    "P5\n# " + grid.cellMm() / MM + " m a cell\n" + grid.width() + " " + grid.height() + "\n255\n";
            out.write(head.getBytes(StandardCharsets.US_ASCII));
            for (int row = grid.height() - 1; row >= 0; row--) {
                for (int column = 0; column < grid.width(); column++) {
                    out.write(pixel(grid.state(column, row)));
                }
            }
        });
        Pose origin = grid.origin();
        WholeFile.replace(
                yaml,
                String.format(
                                Locale.ROOT,
                                "image: %s%nresolution: %s%norigin: [%.6f, %.6f, %.6f]%nnegate: 0%noccupied_thresh: 0.65%nfree_thresh: 0.196%n"
                                        .replace("%n", "\n"),
                                "\"" + base + ".pgm\"",
                                grid.cellMm() / MM,
                                origin.xMm() / MM,
                                origin.yMm() / MM,
                                Math.toRadians(origin.headingDeg()))
                        + places(map.places())
                        + forbidden(map.forbidden()));
    }

    /** A key that is not one of map_server's, which other readers pass over. */
    private static String places(List<NavigationMap.Place> places) {
        StringBuilder lines = new StringBuilder(places.isEmpty() ? "" : PLACES + ":\n");
        for (NavigationMap.Place place : places) {
            Pose pose = place.pose();
            lines.append(String.format(
                    Locale.ROOT,
                    "  - {name: \"%s\", x: %.3f, y: %.3f",
                    place.name().replace('"', '\''),
                    pose.xMm() / MM,
                    pose.yMm() / MM));
            lines.append(
                    place.withHeading()
                            ? String.format(Locale.ROOT, ", yaw: %.6f}\n", Math.toRadians(pose.headingDeg()))
                            : "}\n");
        }
        return lines.toString();
    }

    private static String forbidden(List<NavigationMap.ForbiddenLine> forbidden) {
        StringBuilder lines = new StringBuilder(forbidden.isEmpty() ? "" : FORBIDDEN + ":\n");
        for (NavigationMap.ForbiddenLine line : forbidden) {
            lines.append(String.format(
                    Locale.ROOT,
                    "  - {x1: %.3f, y1: %.3f, x2: %.3f, y2: %.3f}\n",
                    line.fromXmm() / MM,
                    line.fromYmm() / MM,
                    line.toXmm() / MM,
                    line.toYmm() / MM));
        }
        return lines.toString();
    }

    private static int pixel(OccupancyGrid.State state) {
        return switch (state) {
            case OCCUPIED -> 0;
            case FREE -> FREE_PIXEL;
            case UNKNOWN -> UNKNOWN_PIXEL;
        };
    }
}
