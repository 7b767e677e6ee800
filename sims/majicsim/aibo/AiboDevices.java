package majicsim.aibo;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majicsim.aibo.body.Joint;
import majicsim.aibo.body.JointType;
import majicsim.aibo.body.Legs;
import majicsim.aibo.urbi.memory.Blend;
import majicsim.aibo.urbi.memory.Groups;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.value.Value;

/** The dog's devices and their groups (URBI sheet, section 13). */
final class AiboDevices {
    private static final List<String> BACK_LEDS = List.of("ledBFC", "ledBFW", "ledBMC", "ledBMW", "ledBRC", "ledBRW");
    private static final List<String> HEAD_LEDS = List.of("ledHC", "ledHW", "modeR", "modeG", "modeB", "ledWIFI");
    private static final List<String> LEG_NAMES = List.of("RF", "RH", "LF", "LH");

    private final Map<String, Joint> joints = new LinkedHashMap<>();
    private final Variables variables;
    private final Groups groups;

    AiboDevices(Variables variables, Groups groups) {
        this.variables = variables;
        this.groups = groups;
        Stream.concat(JointType.HEAD_AND_TAIL.stream(), JointType.LEGS.stream()).forEach(this::joint);
        JointType.LEGS.forEach(type -> joint(type.name()).angle().blend(Blend.MIX));
        faceLeds().forEach(this::lamp);
        BACK_LEDS.forEach(this::lamp);
        HEAD_LEDS.forEach(this::switched);
        List.of("earL", "earR").forEach(this::switched);
        group();
        legGroups();
    }

    Map<String, Joint> joints() {
        return joints;
    }

    Legs legs() {
        return new Legs(JointType.LEGS.stream().map(type -> joint(type.name())).toList());
    }

    private void joint(JointType type) {
        joints.put(type.name(), new Joint(type, variables));
    }

    private Joint joint(String name) {
        return Objects.requireNonNull(joints.get(name), name);
    }

    /** An LED that can be dimmed: it has the assigned brightness, 0 to 1. */
    private void lamp(String name) {
        install(new Variable(name + ".val", Value.of(0)));
    }

    private void switched(String name) {
        install(new Variable(name + ".val", Value.of(0), new OnOff()));
    }

    private void install(Variable variable) {
        variable.limit(0, 1);
        variables.put(variable);
    }

    private void group() {
        groups.define("head", List.of("neck", "headPan", "headTilt", "mouth"));
        groups.define("tail", List.of("tailPan", "tailTilt"));
        groups.define("ears", List.of("earR", "earL"));
        groups.define("bimotors", List.of("earL", "earR"));
        groups.define("ledF", faceLeds());
        groups.define("ledBW", List.of("ledBFW", "ledBMW", "ledBRW"));
        groups.define("ledBC", List.of("ledBFC", "ledBMC", "ledBRC"));
        groups.define("ledHead", List.of("modeR", "modeG", "modeB", "ledHC", "ledHW"));
        groups.define("bileds", HEAD_LEDS);
        groups.define(
                "leds",
                Stream.of(BACK_LEDS, faceLeds(), List.of("bileds"))
                        .flatMap(List::stream)
                        .toList());
        groups.define("legs", LEG_NAMES.stream().map(leg -> "leg" + leg).toList());
        groups.define("motors", motors());
        groups.define("motor", List.of("motors"));
        sensors();
        List<String> devices =
                List.of("motors", "bimotors", "leds", "touchsensors", "irsensors", "buttonsensors", "accelsensors");
        groups.define("hardware", with(devices, "camera", "speaker", "micro"));
        groups.define("objects", with(devices, "video", "audio_in", "audio_out"));
        groups.define("body", List.of("objects"));
    }

    private void sensors() {
        groups.define("accelsensors", List.of("accelZ", "accelY", "accelX"));
        groups.define("buttonsensors", List.of("pawLF", "pawLH", "pawRF", "pawRH", "chinSensor", "WIFIswitch"));
        groups.define("touchsensors", List.of("headSensor", "backSensorR", "backSensorM", "backSensorF"));
        groups.define("irsensors", List.of("distanceNear", "distance", "distanceChest"));
        groups.define("video", List.of("camera"));
        groups.define("audio_in", List.of("micro"));
        groups.define("audio_out", List.of("speaker"));
    }

    /** The motors in the order in which the stick's script creates them. */
    private static List<String> motors() {
        return Stream.concat(
                        joints(List.of("LF", "LH", "RH", "RF"), List.of(1, 2, 3)).stream(),
                        Stream.of("neck", "headPan", "headTilt", "tailPan", "tailTilt", "mouth"))
                .toList();
    }

    private static List<String> with(List<String> names, String... more) {
        return Stream.concat(names.stream(), Stream.of(more)).toList();
    }

    private void legGroups() {
        for (String leg : LEG_NAMES) {
            groups.define("leg" + leg, joints(List.of(leg), List.of(1, 2, 3)));
        }
        for (int joint = 1; joint <= 3; joint++) {
            List<Integer> number = List.of(joint);
            groups.define("leg" + joint, joints(LEG_NAMES, number));
            groups.define("legF" + joint, joints(List.of("RF", "LF"), number));
            groups.define("legH" + joint, joints(List.of("RH", "LH"), number));
            groups.define("legR" + joint, joints(List.of("RF", "RH"), number));
            groups.define("legL" + joint, joints(List.of("LF", "LH"), number));
            groups.define("legE" + joint, joints(List.of("RF", "LH"), number));
            groups.define("legO" + joint, joints(List.of("LF", "RH"), number));
        }
    }

    private static List<String> joints(List<String> legs, List<Integer> numbers) {
        List<String> names = new ArrayList<>();
        legs.forEach(leg -> numbers.forEach(number -> names.add("leg" + leg + number)));
        return names;
    }

    private static List<String> faceLeds() {
        return IntStream.rangeClosed(1, 14).mapToObj(i -> "ledF" + i).toList();
    }

    /** An LED or an ear that is only on or off (URBI sheet, section 13): on from one half. */
    private static final class OnOff implements Variable.Hardware {
        private static final double ENOUGH = 0.5;

        private boolean on;

        @Override
        public Value measure() {
            return Value.of(on);
        }

        @Override
        public void command(double target) {
            on = target >= ENOUGH;
        }
    }
}
