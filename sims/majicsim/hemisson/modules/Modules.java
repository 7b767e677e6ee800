package majicsim.hemisson.modules;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import majicsim.world.Body;
import majicsim.world.World;

/** All modules, some of which are on the bus. */
public final class Modules {
    final LinearCamera camera;
    final Ultrasonic ultrasonic;
    public final Voice voice = new Voice();
    public final Lcd lcd = new Lcd();
    public final GeneralIo io = new GeneralIo();

    public Modules(World world, Body body) {
        camera = new LinearCamera(world, body);
        ultrasonic = new Ultrasonic(world, body);
    }

    public List<? extends I2cModule> fitted(Set<ModuleKind> kinds) {
        return Stream.of(camera, ultrasonic, voice, lcd, io)
                .filter(module -> kinds.contains(module.kind()))
                .toList();
    }
}
