package majic.gui.add;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import majic.bot.BotType;
import majic.gui.kit.ProgramServices;
import majic.team.BotFactory;
import majic.text.Texts;

/** Creates the input for the address of each type of robot. */
final class AddressInputFactory {
    private static final Texts TEXTS = Texts.of(AddressInputFactory.class);

    private AddressInputFactory() {}

    /** Returns what creates the input of each type and that of the lab, by their names in the drop-down list. */
    static Map<String, Supplier<AddressInput>> all(BotFactory factory, ProgramServices services) {
        Map<String, Supplier<AddressInput>> inputs = new LinkedHashMap<>();
        for (BotType type : factory.types()) {
            inputs.put(title(type), () -> type.canListRobots() ? new SiteInput(type, factory) : of(type, services));
        }
        inputs.put(TEXTS.get("labRobot"), () -> new LabInput(factory, services.startLab()));
        return inputs;
    }

    private static String title(BotType type) {
        return type.label().equals(type.make()) ? type.label() : type.label() + " (" + type.make() + ")";
    }

    private static AddressInput of(BotType type, ProgramServices services) {
        List<AddressInput> ways = type.reaches().stream()
                .map(reach -> reach == BotType.Reach.TCP
                        ? new NetworkInput(type)
                        : new SerialInput(type, services.serialPorts()))
                .toList();
        if (ways.size() == 1) {
            return ways.get(0);
        }
        return new TwoWayInput(
                name(type.reaches().get(0)), ways.get(0), name(type.reaches().get(1)), ways.get(1));
    }

    private static String name(BotType.Reach reach) {
        return switch (reach) {
            case TCP -> TEXTS.get("network");
            case SERIAL -> TEXTS.get("serialPort");
        };
    }
}
