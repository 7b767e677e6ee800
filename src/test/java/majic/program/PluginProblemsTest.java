package majic.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.environment.Settings;
import majic.team.BotFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a broken plug-in is named with the reason, beside one that works. */
@Tag("jdk")
class PluginProblemsTest {
    @TempDir
    private Path folder;

    @TempDir
    private Path sources;

    @BeforeEach
    void aPluginThatWorks() throws IOException {
        turtle("turtle.jar");
    }

    private void turtle(String file) throws IOException {
        PluginJar.of("Turtle$Type").with("Turtle", "Turtle$Type").write(folder.resolve(file));
    }

    /** Checks that there is only one problem, and that the plug-in that works is loaded. */
    private void assertProblem(String sentence) {
        Plugins plugins = Plugins.in(folder);
        assertThat(plugins.problems()).singleElement().asString().startsWith(sentence);
        assertThat(plugins.types())
                .extracting(BotType::name)
                .startsWith("aibo", "pioneer", "hemisson")
                .contains("turtle");
    }

    @Test
    void pluginsThatWorkAreNoProblem() {
        assertThat(Plugins.in(folder).problems()).isEmpty();
    }

    @Test
    void aFileThatIsNoJar() throws IOException {
        Files.writeString(folder.resolve("rubbish.jar"), "this is no jar");

        assertProblem("plug-in rubbish.jar: it is damaged or not a jar: ");
    }

    @Test
    void aJarCutShort() throws IOException {
        byte[] whole = Files.readAllBytes(folder.resolve("turtle.jar"));
        Files.write(folder.resolve("cut.jar"), Arrays.copyOf(whole, whole.length / 2));

        assertProblem("plug-in cut.jar: it is damaged or not a jar: ");
    }

    @Test
    void aJarThatNamesNoType() throws IOException {
        PluginJar.library().with("Turtle").write(folder.resolve("gson.jar"));

        assertProblem("plug-in gson.jar: it names no type of robot: the file META-INF/services/majic.bot.BotType in it"
                + " has to contain the name of a class; a library belongs into the folder lib of its plug-in");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Turtle Type | \"Turtle Type\" in META-INF/services/majic.bot.BotType is not the name of a class",
                "class Turtle; | \"class Turtle;\" in META-INF/services/majic.bot.BotType is not the name of a class",
                "robots.Missing # here | the class robots.Missing is missing, which META-INF/services/majic.bot.BotType"
                        + " names",
                "Cart.Type | the class Cart.Type is missing, which META-INF/services/majic.bot.BotType names; a class"
                        + " within a class is named Cart$Type",
                "Cart | Cart in META-INF/services/majic.bot.BotType does not implement majic.bot.BotType",
                "majic.bot.BotType | majic.bot.BotType has to be a public class with a public constructor without"
                        + " arguments"
            })
    void aLineThatNamesNoType(String line, String reason) throws IOException {
        PluginJar.of(line + "\n").with("Cart", "Cart$Type").write(folder.resolve("cart.jar"));

        assertProblem("plug-in cart.jar: " + reason);
    }

    @Test
    void aBadLineDoesNotAffectTheOtherTypesOfThePlugin() throws IOException {
        PluginJar.of("# carts\nNone\n\nCart$Type").with("Cart", "Cart$Type").write(folder.resolve("cart.jar"));

        assertProblem("plug-in cart.jar: the class None is missing");
        assertThat(Plugins.in(folder).types()).extracting(BotType::name).contains("cart");
    }

    @Test
    void aClassForANewerJava() throws IOException {
        byte[] code = PluginJar.compile(sources, "rover", "Rover").get("Rover");
        code[7] = 99;
        PluginJar.of("Rover").with("Rover", code).write(folder.resolve("rover.jar"));

        assertProblem("plug-in rover.jar: it needs Java 55, and this is Java "
                + Runtime.version().feature());
    }

    @Test
    void aDamagedClass() throws IOException {
        byte[] code = PluginJar.compile(sources, "rover", "Rover").get("Rover");
        PluginJar.of("Rover")
                .with("Rover", Arrays.copyOf(code, code.length / 2))
                .write(folder.resolve("rover.jar"));

        assertProblem("plug-in rover.jar: a class in it is damaged: ");
    }

    /** Writes a plug-in with a type, whose name is that of its class, and a library, but without the type's driver. */
    private void withLibrary(String type, String jar) throws IOException {
        Map<String, byte[]> classes = PluginJar.compile(sources, type.toLowerCase(Locale.ROOT), type);
        PluginJar.of(type)
                .with(type, classes.get(type))
                .with("Library", classes.get("Library"))
                .write(folder.resolve(jar));
    }

    @Test
    void aNameThatAnotherPluginHasAlready() throws IOException {
        turtle("wild/wild.jar");

        assertProblem("plug-in " + Path.of("wild", "wild.jar")
                + ": Turtle$Type has the name turtle, which is that of a type of turtle.jar; remove one of the two");
    }

    @Test
    void aNameThatMajicHasAlready() throws IOException {
        withLibrary("Aibo", "dog.jar");

        assertProblem(
                "plug-in dog.jar: Aibo has the name aibo, which is that of a type of MAJIC itself; remove one of the two");
    }

    @Test
    void aTypeThatNoAddressCanName() throws IOException {
        withLibrary("Sim", "sim.jar");

        assertProblem("plug-in sim.jar: \"sim\" cannot be the name of a type of robot");
    }

    @Test
    void aMissingClassOfALibrary() throws IOException {
        Map<String, byte[]> classes = PluginJar.compile(sources, "rover", "Rover");
        PluginJar.of("Rover").with("Rover", classes.get("Rover")).write(folder.resolve("rover.jar"));

        assertProblem("plug-in rover.jar: the class Library is missing; put the jar with it into the folder lib beside"
                + " the plug-in's own jar");
    }

    @Test
    void aClassThatIsMissingOnlyWhenARobotIsAdded() throws IOException {
        withLibrary("Rover", "rover.jar");
        BotFactory factory = new BotFactory(Plugins.in(folder).types(), Settings.inMemory());

        assertThatThrownBy(() -> factory.create("rover://here"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("rover://here: the driver cannot be loaded: the class Other is missing; ");
    }

    @Test
    void aFolderWithoutAJarOfItsName() throws IOException {
        turtle("tortoise/turtle.jar");

        assertProblem("plug-in " + Path.of("tortoise", "tortoise.jar")
                + ": there is no such file; a plug-in folder has to contain a jar of its own name");
    }

    @Test
    void aDamagedLibrary() throws IOException {
        turtle("tortoise/tortoise.jar");
        Files.createDirectories(folder.resolve("tortoise/lib"));
        Files.writeString(folder.resolve("tortoise/lib/shell.jar"), "this is no jar");

        assertProblem(
                "plug-in " + Path.of("tortoise", "tortoise.jar") + ": its library shell.jar is damaged or not a jar: ");
    }

    @Test
    void twoPluginsBringDifferentVersionsOfOneLibrary() throws IOException {
        rover("rover", "Rover 1");
        rover("lander", "Rover 2");

        assertThat(Plugins.in(folder).types()).extracting(BotType::label).contains("Rover 1", "Rover 2");
        assertThat(Plugins.in(folder).problems()).isEmpty();
    }

    private void rover(String name, String label) throws IOException {
        Map<String, byte[]> classes = PluginJar.compile(sources.resolve(name), name, label);
        String type = Character.toUpperCase(name.charAt(0)) + name.substring(1);
        PluginJar.of(type).with(type, classes.get(type)).write(folder.resolve(name + "/" + name + ".jar"));
        PluginJar.library().with("Library", classes.get("Library")).write(folder.resolve(name + "/lib/library.jar"));
    }
}
