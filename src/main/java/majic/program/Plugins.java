package majic.program;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import majic.bot.BotType;
import majic.team.BotFactory;
import majic.text.IoReason;
import majic.text.VisibleText;

/**
 * The types of robots that there are: MAJIC's own and those of the plug-ins in a folder. A plug-in, or one of its
 * types, that cannot be used is left out, and the others are loaded. Immutable.
 *
 * @param types MAJIC's own first, then the others by name
 * @param problems a sentence for each plug-in or type that was left out, in the order of the plug-ins' names
 */
public record Plugins(List<BotType> types, List<String> problems) {
    /** Copies the lists. */
    public Plugins {
        types = List.copyOf(types);
        problems = List.copyOf(problems);
    }

    /**
     * Loads the plug-ins in a folder. Each problem is also logged, with its cause.
     *
     * @param folder the plug-ins folder; need not exist
     * @return the types and the problems
     */
    public static Plugins in(Path folder) {
        List<BotType> own = BotFactory.types(Plugins.class.getClassLoader());
        return Files.isDirectory(folder) ? new Loading(own).load(folder) : new Plugins(own, List.of());
    }

    /** The loading of the plug-ins in one folder. */
    private static final class Loading {
        private static final System.Logger LOG = System.getLogger(Plugins.class.getName());

        private final List<BotType> own;
        private final List<BotType> added = new ArrayList<>();
        private final Map<String, String> providers = new HashMap<>();
        private final List<String> problems = new ArrayList<>();

        Loading(List<BotType> own) {
            this.own = own;
            own.forEach(type -> providers.put(type.name(), "MAJIC itself"));
        }

        Plugins load(Path folder) {
            try (Stream<Path> entries = Files.list(folder)) {
                entries.filter(Plugin::isPlugin).sorted().map(Plugin::at).forEach(this::load);
            } catch (IOException e) {
                report("the plug-ins folder " + folder + " cannot be read: " + IoReason.of(e), e);
            }
            added.sort(Comparator.comparing(BotType::name));
            return new Plugins(Stream.concat(own.stream(), added.stream()).toList(), problems);
        }

        private void load(Plugin plugin) {
            try {
                for (String typeClass : plugin.typeClasses()) {
                    load(plugin, typeClass);
                }
            } catch (PluginProblem e) {
                report(plugin, e);
            }
        }

        /** A type that cannot be used does not affect the other types of the plug-in. */
        private void load(Plugin plugin, String typeClass) {
            try {
                BotType type = plugin.type(typeClass);
                String other = providers.putIfAbsent(type.name(), plugin.name());
                if (other != null) {
                    throw new PluginProblem(typeClass + " has the name " + type.name() + ", which is that of a type of "
                            + other + "; remove one of the two");
                }
                added.add(type);
            } catch (PluginProblem e) {
                report(plugin, e);
            }
        }

        private void report(Plugin plugin, PluginProblem problem) {
            report("plug-in " + plugin.name() + ": " + problem.getMessage(), problem);
        }

        private void report(String sentence, Exception cause) {
            String visible = VisibleText.of(sentence);
            problems.add(visible);
            LOG.log(Level.WARNING, visible, cause);
        }
    }
}
