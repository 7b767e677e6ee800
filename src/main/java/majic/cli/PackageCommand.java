package majic.cli;

import java.util.concurrent.Callable;
import majic.program.UsageException;
import majic.program.Version;
import picocli.CommandLine.Command;

/**
 * {@code majic package}: the launcher in the folder of the sources carries it out, and does not start this program for
 * it.
 */
@Command(
        name = "package",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Makes, of MAJIC's sources, a program that needs no installed Java, and its installer.")
public final class PackageCommand implements Callable<Integer> {
    @Override
    public Integer call() {
        throw new UsageException("package needs MAJIC's sources; type ./majic package in their folder");
    }
}
