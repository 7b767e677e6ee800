package majic.aibo.body;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The positions of the dog's parts, calculated from its measured joints, with the dog on the ground: x ahead of its
 * middle, y left, z up from the floor, mm. Joints without a reading are taken as in a standing dog. Lengths are
 * rounded. Immutable.
 */
public final class Skeleton {
    private static final BodyPoint NECK_FOOT = new BodyPoint(72, 0, 22);
    private static final BodyPoint NECK = new BodyPoint(0, 0, 76);
    private static final BodyPoint TAIL_FOOT = new BodyPoint(-92, 0, 34);
    private static final BodyPoint TAIL = new BodyPoint(-72, 0, 0);

    /** The tail is mounted pointing up by this much. */
    private static final double TAIL_MOUNT_DEG = 10;

    private static final double PAW_MM = 14;

    /** What else the dog can rest on: its belly and its rump, in the body's frame. */
    private static final List<BodyPoint> BELLY =
            List.of(new BodyPoint(72, 0, -46), new BodyPoint(-72, 0, -46), new BodyPoint(-98, 0, -18));

    private final SensorReadings senses;
    private final Map<Limb, Limb.Bones> legs = new EnumMap<>(Limb.class);
    private final GroundContact contact;

    public Skeleton(SensorReadings senses) {
        this.senses = senses;
        List<BodyPoint> touching = new ArrayList<>(BELLY);
        for (Limb limb : Limb.values()) {
            Limb.Bones bones = limb.bones(senses);
            legs.put(limb, bones);
            touching.add(bones.foot().plus(new BodyPoint(0, 0, -PAW_MM)));
        }
        this.contact = GroundContact.of(
                touching, BodyTilt.of(senses).map(BodyTilt::pitchDeg).orElse(0.0));
    }

    /** How far the body is raised in front, degrees. */
    public double pitchDeg() {
        return contact.pitchDeg();
    }

    /** A point of the body's own frame, whose origin is the middle between the four shoulders. */
    public BodyPoint body(BodyPoint own) {
        return contact.onGround(own);
    }

    public Limb.Bones leg(Limb limb) {
        Limb.Bones bones = legs.getOrDefault(limb, limb.bones(senses));
        return new Limb.Bones(body(bones.top()), body(bones.middle()), body(bones.foot()));
    }

    public BodyPoint neckFoot() {
        return body(NECK_FOOT);
    }

    /** A point of the head's own frame, whose origin is the joint that the head turns and nods about. */
    public BodyPoint head(BodyPoint own) {
        BodyPoint turned = own.raised(angle(Sensor.HEAD_TILT)).panned(angle(Sensor.HEAD_PAN));
        return body(NECK_FOOT.plus(NECK.plus(turned).raised(angle(Sensor.NECK))));
    }

    /** A point of the jaw's own frame, whose origin is its hinge at a place of the head. */
    public BodyPoint jaw(BodyPoint hinge, BodyPoint own) {
        return head(hinge.plus(own.raised(senses.number(Sensor.MOUTH).orElse(-3.0))));
    }

    /** A point along the tail, 0 at the body, 1 at the tip; it is a little bent. */
    public BodyPoint tail(double share) {
        double raised = TAIL_MOUNT_DEG + senses.number(Sensor.TAIL_TILT).orElse(2.0) + 15 * share;
        BodyPoint way = new BodyPoint(TAIL.x() * share, 0, 0).raised(-raised).panned(-angle(Sensor.TAIL_PAN));
        return body(TAIL_FOOT.plus(way));
    }

    private double angle(Sensor sensor) {
        return senses.number(sensor).orElse(0.0);
    }
}
