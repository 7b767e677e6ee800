package majic.pioneer.aria;

import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.Aria;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.stream.Stream;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.ConnectionMaker;
import majic.pioneer.session.PioneerConnection;
import majic.vendor.VendorLibrary;
import org.jspecify.annotations.Nullable;

/** Makes the connections of one robot through ARIA, one after the other with the same {@code ArRobot}. */
public final class AriaConnections implements ConnectionMaker {
    /** ARIA's folder of robot parameters, by which its home is recognised. */
    private static final String PARAMETERS = "params";

    private static boolean initialized;

    private final AriaRobot robot;

    /**
     * Initialises ARIA, once in a process. Made by the class loader of the library.
     *
     * @throws NoSuchMethodException if the installed ARIA lacks a method without which no robot can be driven
     */
    public AriaConnections() throws NoSuchMethodException {
        AriaMethods.check(ArRobot.class);
        initialize();
        ArRobot made = new ArRobot();
        this.robot = new AriaRobot(made, new AriaLaser(made));
    }

    private static synchronized void initialize() {
        if (!initialized) {
            Aria.init(Aria.SigHandleMethod.SIGHANDLE_NONE);
            Path jar = place(ArRobot.class.getProtectionDomain().getCodeSource());
            Aria.setDirectory(home(jar, VendorLibrary.ARIA.home()) + "/");
            initialized = true;
        }
    }

    private static @Nullable Path place(@Nullable CodeSource source) {
        try {
            return source == null ? null : Path.of(source.getLocation().toURI());
        } catch (URISyntaxException e) {
            return null;
        }
    }

    /** The folder above the jar that has ARIA's parameters; the named one if there is none. */
    static Path home(@Nullable Path jar, Path named) {
        return Stream.iterate(jar, folder -> folder != null, Path::getParent)
                .filter(folder -> Files.isDirectory(folder.resolve(PARAMETERS)))
                .findFirst()
                .orElse(named);
    }

    @Override
    public PioneerConnection make(String address, ConnectWait wait) {
        return new AriaConnection(robot, AriaDevice.of(address), wait);
    }
}
