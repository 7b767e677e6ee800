package majicsim.hemisson;

import java.util.List;
import java.util.Optional;

/** The modules by address. Failures are not reported: an absent module reads 255, and writing to it does nothing (sheet 4.5). */
final class I2cBus {
    private static final int NOBODY = 0xFF;

    private final List<I2cModule> modules;

    I2cBus(List<I2cModule> modules) {
        this.modules = List.copyOf(modules);
    }

    List<Integer> addresses() {
        return modules.stream().map(I2cModule::address).sorted().toList();
    }

    int read(int address, int register, int index) {
        return find(address).map(module -> module.read(register, index)).orElse(NOBODY);
    }

    void write(int address, int register, int value) {
        find(address).ifPresent(module -> module.write(register & 0xFF, value));
    }

    void step(double seconds) {
        modules.forEach(module -> module.step(seconds));
    }

    private Optional<I2cModule> find(int address) {
        return modules.stream().filter(module -> module.address() == address).findFirst();
    }
}
