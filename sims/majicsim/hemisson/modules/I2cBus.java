package majicsim.hemisson.modules;

import java.util.List;
import java.util.Optional;

/**
 * The modules by address. Failures are not reported: an absent module, or one that has not started yet, reads 255, and
 * writing to it does nothing (sheet 4.5).
 */
public final class I2cBus {
    private static final int NO_MODULE = 0xFF;

    private final List<? extends I2cModule> modules;
    private double sincePowerUpSeconds = Double.POSITIVE_INFINITY;

    public I2cBus(List<? extends I2cModule> modules) {
        this.modules = List.copyOf(modules);
    }

    /** The modules that answer, by address. */
    public List<ModuleKind> awake() {
        return modules.stream()
                .map(I2cModule::kind)
                .filter(this::isAwake)
                .sorted((a, b) -> a.address() - b.address())
                .toList();
    }

    public int read(int address, int register, int index) {
        return find(address).map(module -> module.read(register, index)).orElse(NO_MODULE);
    }

    public void write(int address, int register, int... bytes) {
        find(address).ifPresent(module -> module.write(register & 0xFF, bytes));
    }

    /** Whether no module measures or speaks. */
    public boolean isIdle() {
        return modules.stream().allMatch(I2cModule::isIdle);
    }

    public void step(double seconds) {
        sincePowerUpSeconds += seconds;
        modules.forEach(module -> module.step(seconds));
    }

    public void powerCycle() {
        sincePowerUpSeconds = 0;
    }

    private boolean isAwake(ModuleKind kind) {
        return sincePowerUpSeconds >= kind.wakeSeconds();
    }

    private Optional<? extends I2cModule> find(int address) {
        return modules.stream()
                .filter(module -> module.kind().address() == address && isAwake(module.kind()))
                .findFirst();
    }
}
