package majic.program;

import picocli.CommandLine.IVersionProvider;

/** Reads MAJIC's version from the jar's manifest. */
public final class Version implements IVersionProvider {
    static String text() {
        String version = Version.class.getPackage().getImplementationVersion();
        return "MAJIC " + (version == null ? "(not from a jar)" : version);
    }

    @Override
    public String[] getVersion() {
        return new String[] {text(), "Java " + Runtime.version()};
    }
}
