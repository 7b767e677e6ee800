package majic.aibo.body;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * Where the parts of the dog are, reckoned from its measured joints, with the dog set on the ground: x ahead of its
 * middle, y left, z up from the floor, mm. Joints that were not read are taken to stand. Lengths are rounded. Immutable.
 */
public final class Skeleton {
    private static final Spot NECK_FOOT = new Spot(72, 0, 22);
    private static final Spot NECK = new Spot(0, 0, 76);
    private static final Spot TAIL_FOOT = new Spot(-92, 0, 34);
    private static final Spot TAIL = new Spot(-72, 0, 0);

    /** The tail is mounted pointing up by this much. */
    private static final double TAIL_MOUNT_DEG = 10;

    private static final double PAW_MM = 14;

    /** What else the dog can rest on: its belly and its rump, in the body's frame. */
    private static final List<Spot> BELLY = List.of(new Spot(72, 0, -46), new Spot(-72, 0, -46), new Spot(-98, 0, -18));

    private final Senses senses;
    private final Map<Limb, Limb.Bones> legs = new EnumMap<>(Limb.class);
    private final Contact contact;

    public Skeleton(Senses senses) {
        this.senses = senses;
        List<Spot> touching = new ArrayList<>(BELLY);
        for (Limb limb : Limb.values()) {
            Limb.Bones bones = limb.bones(senses);
            legs.put(limb, bones);
            touching.add(bones.foot().plus(new Spot(0, 0, -PAW_MM)));
        }
        this.contact =
                Contact.of(touching, Attitude.of(senses).map(Attitude::pitchDeg).orElse(0.0));
    }

    /** How far the body is raised in front, degrees. */
    double pitchDeg() {
        return contact.pitchDeg();
    }

    /** A point of the body's own frame, whose origin is the middle between the four shoulders. */
    public Spot body(Spot own) {
        return contact.onGround(own);
    }

    public Limb.Bones leg(Limb limb) {
        Limb.Bones bones = legs.getOrDefault(limb, limb.bones(senses));
        return new Limb.Bones(body(bones.top()), body(bones.middle()), body(bones.foot()));
    }

    public Spot neckFoot() {
        return body(NECK_FOOT);
    }

    /** A point of the head's own frame, whose origin is the joint that the head turns and nods about. */
    public Spot head(Spot own) {
        Spot turned = own.raised(angle(Sensor.HEAD_TILT)).panned(angle(Sensor.HEAD_PAN));
        return body(NECK_FOOT.plus(NECK.plus(turned).raised(angle(Sensor.NECK))));
    }

    /** A point of the jaw's own frame, whose origin is its hinge at a place of the head. */
    public Spot jaw(Spot hinge, Spot own) {
        return head(hinge.plus(own.raised(senses.number(Sensor.MOUTH).orElse(-3.0))));
    }

    Spot tailFoot() {
        return body(TAIL_FOOT);
    }

    /** A point along the tail, 0 at the body, 1 at the tip; it is a little bent. */
    public Spot tail(double share) {
        double raised = TAIL_MOUNT_DEG + senses.number(Sensor.TAIL_TILT).orElse(2.0) + 15 * share;
        Spot way = new Spot(TAIL.x() * share, 0, 0).raised(-raised).panned(-angle(Sensor.TAIL_PAN));
        return body(TAIL_FOOT.plus(way));
    }

    private double angle(Sensor sensor) {
        return senses.number(sensor).orElse(0.0);
    }
}
