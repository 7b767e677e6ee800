package majic.pioneer.session;

import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipBytes;
import majic.pioneer.state.Scaling;

/** A robot that follows its setpoints with constant acceleration, for tests of its controller. */
public final class RampModel {
    private double acceleration;
    private double deceleration;
    private double turnAcceleration;
    private double wantedSpeed;
    private double wantedRate;
    private double speed;
    private double rate;
    private double x;
    private double y;
    private double heading;

    public RampModel(double acceleration, double deceleration, double turnAcceleration) {
        this.acceleration = acceleration;
        this.deceleration = deceleration;
        this.turnAcceleration = turnAcceleration;
    }

    /** Sets its speed setpoint. */
    public void ramps(double up, double down) {
        acceleration = up;
        deceleration = down;
    }

    public void turnRamp(double upAndDown) {
        turnAcceleration = upAndDown;
    }

    public void pose(double xMm, double yMm, double headingDeg) {
        x = xMm;
        y = yMm;
        heading = headingDeg;
    }

    /** Stops at once and clears the setpoints. */
    public void freeze() {
        speed = 0;
        rate = 0;
        wantedSpeed = 0;
        wantedRate = 0;
    }

    public void speed(int mmPerSec) {
        wantedSpeed = mmPerSec;
    }

    public void rate(int degPerSec) {
        wantedRate = degPerSec;
    }

    public void step(double seconds) {
        double ramp = Math.abs(wantedSpeed) < Math.abs(speed) ? deceleration : acceleration;
        speed = toward(wantedSpeed, speed, ramp * seconds);
        rate = toward(wantedRate, rate, turnAcceleration * seconds);
        heading += rate * seconds;
        x += speed * seconds * Math.cos(Math.toRadians(heading));
        y += speed * seconds * Math.sin(Math.toRadians(heading));
    }

    private static double toward(double wanted, double now, double most) {
        return now + Math.max(-most, Math.min(most, wanted - now));
    }

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }

    public double speed() {
        return speed;
    }

    public double rate() {
        return rate;
    }

    public double heading() {
        return heading;
    }

    public boolean isStationary() {
        return speed == 0 && rate == 0;
    }

    /** Its SIP, with motors on. */
    Sip sip() {
        return Bytes.sip(Bytes.hex(Bytes.wire(0x32, sipData(1, 0))));
    }

    byte[] sipData(int flags, int stallBits) {
        double difference = Math.toRadians(rate) / 0.0056;
        int units = (int) Math.round(heading / Scaling.DEG_PER_UNIT);
        SipBytes data = new SipBytes();
        for (int disc = 0; disc < 16; disc++) {
            data.sonar(disc, 5000);
        }
        return data.pose((int) Math.round(x), (int) Math.round(y), units)
                .wheels((int) Math.round(speed - difference), (int) Math.round(speed + difference))
                .state(stallBits, flags)
                .bytes();
    }
}
