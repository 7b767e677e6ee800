package majic.aibo.parameters;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import majic.aibo.body.DogState;
import majic.aibo.body.Joint;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/**
 * The joints, alone and by limbs: read as measured, set with an optional time that the motion is to take; and how stiff
 * each is. A dog whose legs go loose falls over, so setting that is a motion, too.
 */
final class JointParameters implements ParameterTheme<UrbiVersion> {
    private static final double LONGEST_MS = 30_000;
    private static final double FASTEST_DEG_PER_S = 500;
    private static final Parameter TIME =
            Parameter.number("time", Unit.MS, "how long it takes").within(0, LONGEST_MS);

    private final AiboAccess access;
    private final DogState dog;

    /** Of joints that are given no time; slower than an assignment without a time. */
    private volatile double degPerSec = 120;

    JointParameters(AiboAccess access, DogState dog) {
        this.access = access;
        this.dog = dog;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        for (Joint joint : Joint.values()) {
            Parameter angle = angle(joint, version).with(TIME);
            table.add(angle, access.sensed(joint.sensor(), Unit.DEG))
                    .moves((values, motion) -> turn(List.of(joint), values, motion));
        }
        describeLimb(table, version, "head", List.of(Joint.NECK, Joint.HEAD_PAN, Joint.HEAD_TILT, Joint.MOUTH));
        for (String limb : List.of("tail", "legLF", "legRF", "legLH", "legRH")) {
            describeLimb(table, version, limb, Joint.named(limb));
        }
        describeLimb(table, version, "legs", Joint.named("leg"));
        table.add(
                        Parameter.number("jointSpeed", Unit.DEG_PER_S, "how fast joints turn that are given no time")
                                .within(1, FASTEST_DEG_PER_S),
                        () -> Value.of(degPerSec, Unit.DEG_PER_S))
                .kept()
                .writes(values -> degPerSec = values.get(0).number());
        for (Joint joint : Joint.values()) {
            String variable = joint.urbiName() + ".load";
            table.add(
                            Parameter.number(joint.urbiName() + "Load", Unit.NONE, "its stiffness; 0 loose, 1 stiff")
                                    .within(0, 1),
                            access.asked(variable, load -> Value.of(load, Unit.NONE)))
                    .moves((values, motion) ->
                            stiffen(joint, variable, values.get(0).number(), motion));
        }
    }

    private void stiffen(Joint joint, String variable, double load, Motion motion) {
        access.open().joints().perform(List.of(UrbiCommands.assign(variable, load)), 0, motion);
        if (joint.isInALeg()) {
            dog.setStanding(false);
        }
    }

    private static Parameter angle(Joint joint, UrbiVersion version) {
        Range range = joint.range(version);
        return Parameter.number(joint.urbiName(), Unit.DEG, joint.help()).within(range.min(), range.max());
    }

    private void describeLimb(ParameterTable table, UrbiVersion version, String name, List<Joint> joints) {
        Range first = joints.get(0).range(version);
        Parameter limb = Parameter.list(name, Unit.DEG, names(joints) + "; what set leaves out stays as it is")
                .within(first.min(), first.max());
        for (Joint joint : joints.subList(1, joints.size())) {
            limb = limb.with(angle(joint, version));
        }
        table.add(
                        limb.with(TIME),
                        () -> Value.many(joints.stream().map(this::measured).toList()))
                .moves((values, motion) -> turn(joints, values, motion));
    }

    private static String names(List<Joint> joints) {
        return joints.size() > 4
                ? "legLF1, legLF2, legLF3, then the same of RF, LH and RH"
                : String.join(", ", joints.stream().map(Joint::urbiName).toList());
    }

    private Value measured(Joint joint) {
        return access.senses().value(joint.sensor(), 1, Unit.DEG);
    }

    /** The values are one for each joint from the first on, and behind all of them the time. */
    private void turn(List<Joint> joints, List<Value> values, Motion motion) {
        Map<Joint, Double> targets = new EnumMap<>(Joint.class);
        int given = Math.min(joints.size(), values.size());
        for (int index = 0; index < given; index++) {
            targets.put(joints.get(index), values.get(index).number());
        }
        OptionalDouble ms =
                values.size() > given ? OptionalDouble.of(values.get(given).number()) : OptionalDouble.empty();
        access.open().joints().turn(targets, ms, degPerSec, motion);
    }
}
