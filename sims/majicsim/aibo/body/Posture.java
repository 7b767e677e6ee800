package majicsim.aibo.body;

import java.util.List;

/** The postures of the stick by the angles of their legs (URBI sheet, section 15). */
enum Posture {
    STAND("stand", new ShoulderPose(160, 0), List.of(-20.0, 25.0, 90.0), List.of(-25.0, 10.0, 80.0)),
    SIT("sit", new ShoulderPose(180, 35), List.of(-45.0, -10.0, 10.0), List.of(-75.0, 15.0, 120.0)),
    BEG("sit", new ShoulderPose(200, 60), List.of(-20.0, 5.0, 115.0), List.of(-55.0, -10.0, 115.0)),
    LAY("lay", new ShoulderPose(75, 0), List.of(0.0, -5.0, 40.0), List.of(-120.0, 0.0, 120.0)),
    INITIAL("lay", new ShoulderPose(75, 0), List.of(55.0, -5.0, 40.0), List.of(-120.0, 0.0, 120.0)),
    STAND_UP("stand", new ShoulderPose(180, 0), List.of(-6.0, 3.5, 30.0), List.of(-6.0, 3.5, 30.0)),
    SIT_DOWN("sit", new ShoulderPose(180, 35), List.of(-26.0, -6.0, 20.0), List.of(-80.0, 19.0, 110.0)),
    WALKING("stand", new ShoulderPose(150, 0), List.of(-17.4, 10.0, 80.5), List.of(-28.8, 11.1, 90.3));

    private final String guess;
    private final ShoulderPose shoulders;
    private final List<Double> front;
    private final List<Double> hind;

    Posture(String guess, ShoulderPose shoulders, List<Double> front, List<Double> hind) {
        this.guess = guess;
        this.shoulders = shoulders;
        this.front = front;
        this.hind = hind;
    }

    /** Its name as MyguessPosition reports it. */
    String guess() {
        return guess;
    }

    /** The height and pitch of its front. */
    ShoulderPose shoulders() {
        return shoulders;
    }

    /** The angle of joint 1, 2 or 3 in degrees, before it is clipped to the joint's range. */
    double angleDeg(boolean isFront, int joint) {
        return (isFront ? front : hind).get(joint - 1);
    }
}
